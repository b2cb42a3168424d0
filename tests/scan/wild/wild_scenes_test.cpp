// SPDX-License-Identifier: Apache-2.0
// What the wild scenes of facades promise: the same bytes for any number of threads, truth that agrees with the points,
// forms that can be left out, and files that say what an office knows.
#include "scan/wild/facade/wild_scenes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "kernels/core/parallel.h"
#include "scan/wild/facade/wild_front.h"

namespace ilot::scan {
namespace {

using WildPlan = WildScan (*)(const SceneValues&, std::uint64_t);

struct WildCase {
  WildPlan plan;
  std::span<const std::string_view> groups;
};
const std::array<WildCase, 3> kWildCases{
    {{plan_facade_wild, kFacadeWildGroups}, {plan_row_wild, kRowWildGroups}, {plan_court_wild, kCourtWildGroups}}};

// No registration error, no strays, little noise.
const std::vector<const char*> kCalm{"scene.registration_shift=0",    "scene.registration_turn=0",
                                     "scene.stray_points=0",          "scene.incidence_bias=0",
                                     "scene.range_noise=0.001",       "scene.angle_noise=0.0005",
                                     "scene.coordinate_grid=tenth_mm"};

WildScan wild_scan(const WildCase& scene, std::uint64_t seed, const std::vector<const char*>& settings = {},
                   bool bare = false) {
  SceneValues values(drawn_options(scene.groups));
  for (const char* setting : settings) values.set(setting);
  const std::vector<std::string_view> families = families_of(scene.groups);
  if (bare)
    for (std::string_view family : families) values.leave_out(family, families);
  return scene.plan(values, seed);
}

std::vector<std::byte> wild_bytes(const WildScan& scan, int threads = 2) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_wild(scan, [&](std::span<const std::byte> r) { all.insert(all.end(), r.begin(), r.end()); });
  });
  return all;
}

void each_point(const WildScan& scan, const std::function<void(Vec3, const RecordTruth&)>& visit) {
  const RecordLayout layout = wild_layout(scan);
  const std::vector<std::byte> bytes = wild_bytes(scan);
  for (std::size_t at = 0; at < bytes.size(); at += layout.record_length)
    visit(place_of(&bytes[at], layout), truth_of(&bytes[at], layout));
}

TEST(WildScenes, SameBytesForAnyNumberOfThreads) {
  const std::array<const char*, 3> platforms{"scene.platform=stations", "scene.platform=vehicle",
                                             "scene.platform=stations"};
  for (std::size_t i = 0; i < kWildCases.size(); ++i) {
    WildScan scan = wild_scan(kWildCases[i], 3, {platforms[i], "scene.density=60"});
    fit_density(scan, 8000, 8000);
    const std::vector<std::byte> one = wild_bytes(scan, 1);
    EXPECT_GT(one.size(), 39u * 4000);
    EXPECT_TRUE(wild_bytes(scan, 3) == one);
  }
}

TEST(WildScenes, ASeedGivesTheSameSceneAndAnotherSeedAnother) {
  for (const WildCase& scene : kWildCases) {
    const WildScan a = wild_scan(scene, 1), b = wild_scan(scene, 1), c = wild_scan(scene, 2);
    ASSERT_EQ(a.scene.model.parts.size(), b.scene.model.parts.size());
    EXPECT_NE(a.scene.model.parts.size(), c.scene.model.parts.size());
  }
}

// On flat walls, every labelled point lies on its plane within the noise of the range, the mixing that it hides and the
// noise of the angles. On walls that bow it lies within the bow as well.
TEST(WildScenes, PointsLieOnTheirTruePlanes) {
  for (const WildCase& scene : kWildCases)
    for (std::uint64_t seed : {1}) {
      WildScan scan = wild_scan(scene, seed, kCalm);
      fit_density(scan, 30000, 30000);
      std::map<std::uint32_t, Plane> planes;
      for (const TruePlane& p : scan.scene.planes) EXPECT_TRUE(planes.emplace(p.id, p.plane).second);
      std::size_t on_planes = 0;
      each_point(scan, [&](Vec3 p, const RecordTruth& truth) {
        const auto plane = planes.find(truth.true_plane);
        if (plane == planes.end()) return;
        ++on_planes;
        // 3 cm of lean and of bow both ways less the plane in least squares, 2 cm of rough stone, 1 cm of noise.
        ASSERT_LT(std::abs(signed_distance(plane->second, p)), 0.09) << truth.true_plane << " of seed " << seed;
      });
      EXPECT_GT(on_planes, 5000u);
    }
}

TEST(WildScenes, FlatSmoothWallsAreFlatToTheNoise) {
  std::vector<const char*> settings = kCalm;
  for (const char* flat : {"scene.wall_lean=0", "scene.bow_across=0", "scene.bow_up=0", "scene.roughness=0.0002",
                           "scene.wall_kind=render"})
    settings.push_back(flat);
  WildScan scan = wild_scan(kWildCases[0], 5, settings);
  fit_density(scan, 30000, 30000);
  std::map<std::uint32_t, Plane> walls;
  for (const TruePlane& p : scan.scene.planes)
    if (p.surface_class == "facade") walls.emplace(p.id, p.plane);
  std::size_t points = 0;
  each_point(scan, [&](Vec3 p, const RecordTruth& truth) {
    if (walls.count(truth.true_plane) == 0) return;
    ++points;
    ASSERT_LT(std::abs(signed_distance(walls.at(truth.true_plane), p)), 0.007);
  });
  EXPECT_GT(points, 5000u);
}

// What belongs to the reveal of a window lies in its opening: between the wall's surface and the frame, and within a
// few millimetres of its outline.
TEST(WildScenes, RevealsLieInTheirOpenings) {
  std::vector<const char*> settings = kCalm;
  settings.push_back("scene.reveal=0.3");
  settings.push_back("scene.platform=stations");
  WildScan scan = wild_scan(kWildCases[0], 2, settings);
  fit_density(scan, 50000, 50000);
  std::map<std::uint32_t, const TrueElement*> windows;
  for (const TrueElement& e : scan.scene.elements)
    if (e.kind == "window") windows.emplace(e.id, &e);
  std::size_t points = 0;
  each_point(scan, [&](Vec3 p, const RecordTruth& truth) {
    const auto window = windows.find(truth.true_element);
    if (window == windows.end() || truth.true_class != static_cast<std::uint8_t>(WildClass::reveal)) return;
    const TrueElement& e = *window->second;
    const Vec3 width = e.ring[1] - e.ring[0], along = (1 / norm(width)) * width, out = cross(along, Vec3{0, 0, 1});
    const double x = dot(along, p - e.ring[0]), o = dot(out, p - e.ring[0]), z = p.z - e.ring[0].z;
    ++points;
    EXPECT_GT(x, -0.02);
    EXPECT_LT(x, e.width + 0.02);
    EXPECT_GT(z, -0.03);
    EXPECT_LT(z, e.height + 0.03);
    EXPECT_GT(o, e.depth - 0.02);
    EXPECT_LT(o, 0.03);
  });
  EXPECT_GT(points, 100u);
}

TEST(WildScenes, OpeningsAndControlPointsBelongToElementsWithinTheCrop) {
  for (const WildCase& scene : kWildCases)
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const WildScan scan = wild_scan(scene, seed);
      std::map<std::uint32_t, const TrueElement*> elements;
      for (const TrueElement& e : scan.scene.elements) {
        EXPECT_TRUE(elements.emplace(e.id, &e).second);
        EXPECT_GE(e.ring.size(), 3u);
      }
      for (const TrueOpening& o : scan.scene.openings) {
        ASSERT_EQ(elements.count(o.element), 1u);
        for (Vec3 p : o.ring) EXPECT_TRUE(scan.crop.contains(p));
        EXPECT_GT(elements.at(o.element)->width, 0.2);
      }
      for (const TrueControlPoint& p : scan.scene.control_points) EXPECT_EQ(elements.count(p.element), 1u);
    }
}

TEST(WildScenes, FamiliesAppearAndCanBeLeftOut) {
  const std::set<std::string> wild{"shutter", "plant",  "car",     "person",   "tree",     "hedge",
                                   "cable",   "sign",   "awning",  "fixture",  "balcony",  "scaffold",
                                   "pipe",    "band",   "cornice", "pilaster", "lamppost", "furniture",
                                   "chimney", "dormer", "sill",    "lintel"};
  std::set<std::string> seen;
  std::set<std::size_t> arcs;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const TrueElement& e : wild_scan(kWildCases[1], seed).scene.elements) {
      seen.insert(e.kind);
      arcs.insert(e.arcs.size());
    }
    for (const TrueElement& e : wild_scan(kWildCases[1], seed, {}, true).scene.elements) {
      EXPECT_EQ(wild.count(e.kind), 0u) << e.kind;
      EXPECT_TRUE(e.arcs.empty());
    }
  }
  for (const std::string& kind : wild) EXPECT_EQ(seen.count(kind), 1u) << kind;
  EXPECT_EQ(arcs, (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST(WildScenes, FixedValuesReachTheScene) {
  const WildScan none = wild_scan(kWildCases[0], 4, {"scene.panes_without_echo=0", "scene.range_noise=0.005"});
  const WildScan all = wild_scan(kWildCases[0], 4, {"scene.panes_without_echo=1", "scene.range_noise=0.005"});
  const auto dark = [](const WildScan& scan) {
    return std::count_if(scan.scene.model.surfaces.begin(), scan.scene.model.surfaces.end(),
                         [](const SurfaceLabel& l) { return l.material == Material::dark_glass; });
  };
  EXPECT_EQ(dark(none), 0);
  EXPECT_GT(dark(all), 0);
  EXPECT_EQ(none.beam.range_noise, 0.005);
  EXPECT_EQ(none.scene.elements.size(), all.scene.elements.size());  // nothing else has changed
}

TEST(WildScenes, RowsHaveThreeToTwelveHouses) {
  std::set<std::size_t> counts;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const WildScan scan = wild_scan(kWildCases[1], seed, {"scene.density=60", "scene.opposite=none"});
    const auto walls = std::count_if(scan.scene.planes.begin(), scan.scene.planes.end(),
                                     [](const TruePlane& p) { return p.surface_class == "facade" && p.area > 0; });
    counts.insert(static_cast<std::size_t>(walls));
  }
  EXPECT_EQ(*counts.begin(), 3u);
  EXPECT_EQ(*counts.rbegin(), 12u);
}

// The files of a scan, and the text of each.
struct WildFiles {
  nlohmann::json truth;
  std::string stations;
  ScanCounts counts;
};

WildFiles write_files(const std::vector<const char*>& settings) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("ilot_wild_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  ScanRequest request{"facade-wild", SceneValues(drawn_options(kFacadeWildGroups)), 0, 8000, folder / "a.las"};
  for (const char* setting : settings) request.values.set(setting);
  WildFiles files;
  files.counts = scan_wild_scene<plan_facade_wild>(request);
  files.truth = nlohmann::json::parse(std::ifstream(folder / "a.truth.json"));
  std::stringstream text;
  text << std::ifstream(folder / "a.stations.csv").rdbuf();
  files.stations = text.str();
  std::filesystem::remove_all(folder);
  return files;
}

TEST(WildScenes, FilesSayWhatAnOfficeKnows) {
  const WildFiles known =
      write_files({"scene.platform=stations", "scene.station_knowledge=known", "scene.station_steps=given"});
  EXPECT_EQ(known.truth["distributions_sha256"], distributions_hash());
  EXPECT_EQ(known.stations.rfind("name,x,y,z,azimuth_step_deg", 0), 0u);
  std::set<std::string> names;
  for (const auto& drawn : known.truth["drawn"]) names.insert(drawn["name"].get<std::string>());
  EXPECT_EQ(names.count("density_reached"), 1u);
  const auto draws_from = [](std::string_view group) {
    return std::find(kFacadeWildGroups.begin(), kFacadeWildGroups.end(), group) != kFacadeWildGroups.end();
  };
  for (const Distribution& row : distributions())
    EXPECT_EQ(names.count(std::string(row.name)), row.per == "scene" && draws_from(row.group)) << row.name;
  EXPECT_FALSE(known.truth["drawn_elements"].empty());
  EXPECT_FALSE(known.truth["drawn_shares"].empty());
  EXPECT_FALSE(known.truth["openings"].empty());
  const WildFiles bare =
      write_files({"scene.platform=stations", "scene.station_knowledge=near", "scene.station_steps=missing"});
  EXPECT_EQ(bare.stations.rfind("name,x,y,z\n", 0), 0u);
  const auto x_of = [](const std::string& text) { return std::stod(text.substr(text.find('\n') + 3)); };
  EXPECT_NE(x_of(known.stations), x_of(bare.stations));
  EXPECT_NEAR(x_of(known.stations), x_of(bare.stations), 0.35);
  EXPECT_EQ(write_files({"scene.station_knowledge=unknown"}).stations, "");
}

// Of this row the only station sees less than half of the walls.
TEST(WildScenes, WallsThatNobodySeesDoNotCount) {
  WildScan scan = wild_scan(kWildCases[1], 11);
  EXPECT_GT(fit_density(scan, 5000, 5000), 0);
}

TEST(WildScenes, MissingFieldsAreMissing) {
  std::vector<const char*> settings{"scene.intensity=missing", "scene.source_id=missing", "scene.colour=missing"};
  WildScan scan = wild_scan(kWildCases[0], 2, settings);
  EXPECT_EQ(wild_layout(scan).point_format, 6);
  settings.back() = "scene.colour=eight_bit";
  scan = wild_scan(kWildCases[0], 2, settings);
  EXPECT_EQ(wild_layout(scan).point_format, 7);
  fit_density(scan, 5000, 5000);
  const RecordLayout layout = wild_layout(scan);
  const std::vector<std::byte> bytes = wild_bytes(scan);
  for (std::size_t at = 0; at < bytes.size(); at += layout.record_length) {
    const PointFields f = decode_fields({&bytes[at], 36}, 7);
    EXPECT_EQ(f.intensity, 0);
    EXPECT_EQ(f.source_id, 0);
    EXPECT_LT(load<std::uint16_t>(&bytes[at] + 30), 256);
  }
}

}  // namespace
}  // namespace ilot::scan
