// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/make_facades.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "engine/deliverables/tables/facade_json.h"
#include "engine/run/run.h"
#include "kernels/core/portable_math.h"
#include "tests/support/cloud_store.h"
#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

using nlohmann::json;

constexpr Vec3 kEye{-2, 1.2, 7};
constexpr double kEast = 651000, kNorth = 661000;

// A wall of two windows with sills, turned about the vertical and shifted to a national grid; millimetres.
std::vector<Index3> wall_points(double heading) {
  test::ScannedWall wall;
  wall.wall({{2, 0, 1, 2.1, 1.5, 3.2}, {2, 0, 3.5, 4.6, 1.5, 3.2}});
  wall.block(0.93, 2.17, 1.36, 1.5, 0.09, 2);
  wall.block(3.43, 4.67, 1.36, 1.5, 0.09, 3);
  const double c = cos_degrees(heading), s = cos_degrees(heading - 90);
  std::vector<Index3> points;
  for (const FacadePoint& p : test::scan_wall(wall, kEye, 0.0025).points) {
    const double x = p.u * c + p.w * s, y = p.u * s - p.w * c;
    points.push_back({std::llround((kEast + x) * 1000), std::llround((kNorth + y) * 1000), std::llround(p.v * 1000.0)});
  }
  return points;
}

// What the labelled cloud says of a point, and where that is on the wall, metres.
struct RowOfCloud {
  double u = 0, v = 0, w = 0;
  std::uint16_t facade = 0;
  std::uint32_t element = 0;
  std::uint8_t label = 0;
};

std::vector<RowOfCloud> labelled_points(const std::filesystem::path& cloud, double heading) {
  const auto reader = open_cloud(cloud);
  const RecordLayout& layout = reader->info().layout;
  std::vector<std::byte> records(reader->info().points * layout.record_length);
  std::vector<std::uint8_t> valid(reader->info().points);
  reader->read(0, records, valid);
  const auto offset = [&](const char* name) {
    for (const ExtraField& field : layout.extra)
      if (field.name == name) return field.offset;
    ADD_FAILURE() << name;
    return std::uint16_t{0};
  };
  const std::uint16_t facade = offset("facade_id"), element = offset("element_id"), label = offset("label");
  const double c = cos_degrees(heading), s = cos_degrees(heading - 90);
  std::vector<RowOfCloud> points;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const std::byte* r = records.data() + i * layout.record_length;
    const double x = load<std::int32_t>(r) * 0.001 - kEast, y = load<std::int32_t>(r + 4) * 0.001 - kNorth;
    points.push_back({x * c + y * s, load<std::int32_t>(r + 8) * 0.001, x * s - y * c, load<std::uint16_t>(r + facade),
                      load<std::uint32_t>(r + element), load<std::uint8_t>(r + label)});
  }
  return points;
}

struct FacadesOutcome {
  int code = 0;
  json record;
  std::vector<Facade> facades;
  std::set<std::string> files;  // of the facades
  std::vector<RowOfCloud> points;
  std::string drawing;  // of the first facade, as SVG
};

FacadesOutcome run_wall(const std::vector<Index3>& points, double heading, bool with_station,
                        const std::function<void(RunOptions&)>& change = {}) {
  const TemporaryFolder folder;
  const auto cloud = folder.path() / "wall.las", stations = folder.path() / "stations.csv";
  test::write_cloud(cloud, points);
  const double c = cos_degrees(heading), s = cos_degrees(heading - 90);
  std::ofstream(stations) << std::fixed << "x y z azimuth_step_deg elevation_step_deg\n"
                          << kEast + kEye.x * c + kEye.z * s << ' ' << kNorth + kEye.x * s - kEye.z * c << ' ' << kEye.y
                          << " 0.14 0.14\n";
  RunOptions options;
  options.inputs = {cloud};
  options.output = folder.path() / "out";
  options.products = {"facades"};
  options.crs = "EPSG:2154";
  options.threads = 2;
  if (with_station) options.stations = stations;
  if (change) change(options);
  Progress progress;
  FacadesOutcome out;
  out.code = run(options, progress);
  std::stringstream text;
  text << std::ifstream(options.output / "run.json").rdbuf();
  out.record = json::parse(text.str());
  out.points = labelled_points(options.output / "points" / "wall.laz", heading);
  std::error_code none;  // without a facade there is no folder of them
  for (const auto& file : std::filesystem::directory_iterator(options.output / "facades", none)) {
    out.files.insert(file.path().filename());
    if (file.path().filename() == "facade-001.svg") {
      std::stringstream svg;
      svg << std::ifstream(file.path()).rdbuf();
      out.drawing = svg.str();
    }
    if (file.path().extension() == ".json") out.facades.push_back(read_facade_json(file.path()));
  }
  return out;
}

std::vector<FacadeElement> windows_of(const Facade& facade) {
  std::vector<FacadeElement> windows;
  for (const FacadeElement& e : facade.elements)
    if (e.kind == "window") windows.push_back(e);
  return windows;
}

TEST(FacadesProduct, FromCloudToPlanHoweverTheWallStands) {
  for (const double heading : {0.0, 33.0, 200.0}) {
    const FacadesOutcome out = run_wall(wall_points(heading), heading, true);
    EXPECT_EQ(out.code, 0);
    EXPECT_EQ(out.record["counts"]["facades"]["facades"], 1);
    ASSERT_EQ(out.facades.size(), 1u) << heading;
    const auto windows = windows_of(out.facades[0]);
    ASSERT_EQ(windows.size(), 2u) << heading;
    EXPECT_EQ(out.facades[0].crs, "EPSG:2154");
    const double c = cos_degrees(heading), s = cos_degrees(heading - 90);
    for (std::size_t i = 0; i < 2; ++i) {
      const double u = 1 + 2.5 * static_cast<double>(i);
      const Vec3 truth{kEast + (u + 1.1) * c, kNorth + (u + 1.1) * s, 3.2};
      EXPECT_LT(norm(windows[i].ring[2] - truth), 0.006) << heading;
      EXPECT_NEAR(windows[i].width_m, 1.1, 0.008) << heading;
      EXPECT_NEAR(windows[i].depth_m, -0.25, 0.004) << heading;
    }
    bool staged = false;
    for (const json& stage : out.record["stages"]) staged |= stage["name"] == "facades";
    EXPECT_TRUE(staged);
  }
}

// From points to the polygon in the JSON: every slope within what its edge says, with stations and without.
TEST(FacadesProduct, AGableIsDrawnAsOne) {
  const auto gable = [](double u) { return 2.2 + 0.6 * (3 - std::abs(u - 3)); };
  test::ScannedWall wall;
  wall.wall({});
  std::vector<Index3> points;
  for (const FacadePoint& p : test::scan_wall(wall, kEye, 0.0025).points)
    if (p.v <= gable(p.u))
      points.push_back(
          {std::llround((kEast + p.u) * 1000), std::llround((kNorth - p.w) * 1000), std::llround(p.v * 1000.0)});
  for (const bool with_station : {true, false}) {
    const FacadesOutcome out = run_wall(points, 0, with_station);
    ASSERT_EQ(out.facades.size(), 1u);
    const FacadeElement& outline = out.facades[0].elements[0];
    ASSERT_EQ(outline.kind, "outline");
    ASSERT_EQ(outline.ring.size(), 5u);
    EXPECT_NEAR(outline.height_m, 4, 0.03);
    for (const std::size_t i : {2u, 3u}) {
      const FacadeEdge& edge = outline.edges[i];
      EXPECT_EQ(edge.status, DrawnStatus::seen);
      EXPECT_LT(edge.error_m, 0.03);
      EXPECT_GT(edge.points, 50u);
      EXPECT_GT(edge.covered_share, 0.9);
      for (const double share : {0.05, 0.5, 0.95}) {
        const Vec3 at = outline.ring[i] + share * (outline.ring[i + 1] - outline.ring[i]);
        EXPECT_LT(std::abs(at.z - gable(at.x - kEast)) / std::sqrt(1.36), edge.error_m) << with_station << i << share;
      }
    }
  }
}

TEST(FacadesProduct, PointsSayWhichElementTheyAreOf) {
  const FacadesOutcome out = run_wall(wall_points(33), 33, true);
  ASSERT_EQ(out.facades.size(), 1u);
  std::map<std::uint32_t, std::string> kinds;
  for (const FacadeElement& e : out.facades[0].elements) kinds[e.id] = e.kind;
  std::map<std::string, std::size_t> of_kind;
  std::size_t wrong = 0;
  for (const RowOfCloud& p : out.points) {
    const bool over_window = (p.u > 1.01 && p.u < 2.09) || (p.u > 3.51 && p.u < 4.59);
    const char* kind = nullptr;
    if (p.w < -0.24) kind = "window";
    if (p.w > 0.08 && p.v < 1.49) kind = "sill";
    if (std::abs(p.w) < 0.004 && !over_window && p.v > 1.7 && p.v < 3.9 && p.u > 0.1 && p.u < 5.9) kind = "outline";
    if (kind == nullptr) continue;
    ++of_kind[kind];
    const int label = kind == std::string("window") ? 6 : kind == std::string("sill") ? 8 : 5;
    wrong += p.facade != 1 || p.label != label || kinds[p.element] != kind;
  }
  EXPECT_GT(of_kind["window"], 500u);
  EXPECT_GT(of_kind["sill"], 100u);
  EXPECT_GT(of_kind["outline"], 5000u);
  EXPECT_LE(wrong, out.points.size() / 1000);
  EXPECT_EQ(out.record["counts"]["points"]["read"], out.points.size());
  EXPECT_NE(out.drawing.find("wall.las"), std::string::npos) << "the title block names its source";
}

const FacadeElement& only(const Facade& facade, const std::string& kind) {
  const auto at = std::find_if(facade.elements.begin(), facade.elements.end(),
                               [&](const FacadeElement& e) { return e.kind == kind; });
  EXPECT_NE(at, facade.elements.end()) << kind;
  return *at;
}

TEST(FacadesProduct, EachEdgeSaysWhatSupportsIt) {
  const FacadesOutcome out = run_wall(wall_points(33), 33, true);
  ASSERT_EQ(out.facades.size(), 1u);
  const FacadeElement &wall = only(out.facades[0], "outline"), &window = only(out.facades[0], "window"),
                      &sill = only(out.facades[0], "sill");
  ASSERT_EQ(wall.faces.size(), 1u);
  EXPECT_GT(wall.faces[0].points, 50000u);
  EXPECT_LT(wall.faces[0].rms_m, 0.003);  // noise of 2 mm
  EXPECT_EQ(wall.edges.size(), 4u);
  for (const FacadeEdge& e : wall.edges) EXPECT_GT(e.points, 100u);
  // The station stands to the left and below: it sees the right reveal and the soffit, and the sill hides the bottom.
  EXPECT_GT(window.edges[1].points, 200u);
  EXPECT_LT(window.edges[1].rms_m, 0.004);
  EXPECT_EQ(window.edges[1].occluded_share, 0);
  EXPECT_GT(window.edges[0].occluded_share, 0.9);
  std::map<std::string, FacadeFace> faces;
  for (const FacadeFace& f : window.faces) faces[f.name] = f;
  EXPECT_EQ(faces["left"].occluded_share, 1);
  EXPECT_EQ(faces["left"].points, 0u);
  EXPECT_LT(faces["right"].occluded_share, 0.1);
  EXPECT_GT(faces["right"].points, 200u);
  EXPECT_LT(faces["right"].rms_m, 0.004);
  EXPECT_GT(faces["front"].points, 2000u);
  for (const FacadeEdge& e : sill.edges) EXPECT_EQ(e.occluded_share, 0) << "its front is seen whole";
}

TEST(FacadesProduct, ABoardInTheStreetHidesAKnownPartOfAJamb) {
  // 1.5 m before the wall it hides, of the left jamb of the second window, what lies below z = 2.35: half.
  constexpr double kBoardTop = 1.2 + (2.35 - 1.2) * 5.5 / 7;
  test::ScannedWall wall;
  wall.wall({{2, 0, 1, 2.1, 1.5, 3.2}, {2, 0, 3.5, 4.6, 1.5, 3.2}});
  wall.sheets.push_back({2, 1.5, 1.9, 2.6, 0.9, kBoardTop, 5});
  std::vector<Index3> points;
  for (const FacadePoint& p : test::scan_wall(wall, kEye, 0.0025).points)
    points.push_back(
        {std::llround((kEast + p.u) * 1000), std::llround((kNorth - p.w) * 1000), std::llround(p.v * 1000.0)});
  const FacadesOutcome out = run_wall(points, 0, true);
  ASSERT_EQ(out.facades.size(), 1u);
  const auto windows = windows_of(out.facades[0]);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_NEAR(*windows[1].edges[3].occluded_share, 0.5, 0.03);
  EXPECT_EQ(windows[1].edges[2].occluded_share, 0);
  EXPECT_EQ(windows[0].edges[3].occluded_share, 0);
}

TEST(FacadesProduct, NothingDependsOnThreadsOrBlocks) {
  const auto points = wall_points(33);
  std::string hash;
  for (const auto& [threads, block_points] : {std::pair{1, 1u << 20}, {3, 1u << 20}, {2, 5000u}}) {
    const FacadesOutcome out = run_wall(points, 33, true, [&, t = threads, b = block_points](RunOptions& o) {
      o.threads = t;
      o.settings.index.block_points = b;
    });
    const std::string got = out.record["result_hash"];
    if (hash.empty()) hash = got;
    EXPECT_EQ(got, hash) << threads << " " << block_points;
  }
}

TEST(FacadesProduct, EveryFacadeComesWithItsDrawings) {
  const FacadesOutcome out = run_wall(wall_points(0), 0, true, [](RunOptions& o) {
    o.settings.facades.sections = {2.5};
    o.settings.facades.upright_sections = {1.5, 99};  // there is no wall at 99 m
    o.settings.facades.section_lines = {kEast + 4, kNorth - 3, kEast + 4, kNorth + 3, 0, 0, 9, 9};
  });
  const std::set<std::string> wanted{"facade-001.csv",
                                     "facade-001.dxf",
                                     "facade-001.json",
                                     "facade-001.obj",
                                     "facade-001.pdf",
                                     "facade-001.pgw",
                                     "facade-001.png",
                                     "facade-001.stl",
                                     "facade-001.svg",
                                     "facade-001-section-level-2.50.dxf",
                                     "facade-001-section-level-2.50.pdf",
                                     "facade-001-section-level-2.50.svg",
                                     "facade-001-section-line-1.dxf",
                                     "facade-001-section-line-1.pdf",
                                     "facade-001-section-line-1.svg",
                                     "facade-001-section-x-1.50.dxf",
                                     "facade-001-section-x-1.50.pdf",
                                     "facade-001-section-x-1.50.svg"};
  EXPECT_EQ(out.files, wanted);
}

TEST(FacadesProduct, WithoutStationsItWarns) {
  const FacadesOutcome out = run_wall(wall_points(0), 0, false);
  ASSERT_EQ(out.facades.size(), 1u);
  const std::vector<FacadeElement> windows = windows_of(out.facades[0]);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_FALSE(windows[0].edges.empty());
  for (const FacadeEdge& e : windows[0].edges) EXPECT_FALSE(e.occluded_share);
  ASSERT_FALSE(out.record["warnings"].empty());
  EXPECT_NE(out.record["warnings"].dump().find("station"), std::string::npos);
}

TEST(FacadesProduct, ASettingTurnsAFacadeAndNamesThoseThatAreNotThere) {
  const FacadesOutcome as_found = run_wall(wall_points(0), 0, false);
  const FacadesOutcome turned = run_wall(wall_points(0), 0, false, [](RunOptions& o) {
    o.settings.facades.side = {1, 7};
  });
  ASSERT_EQ(turned.facades.size(), 1u);
  const auto &from = as_found.facades.at(0).out, &to = turned.facades[0].out;
  EXPECT_LT(from.x * to.x + from.y * to.y + from.z * to.z, -0.999);
  EXPECT_NE(turned.record["warnings"].dump().find("there is no facade 7"), std::string::npos);
}

TEST(FacadesProduct, NoFacadeIsNoFailure) {
  std::vector<Index3> ground;
  Rng rng(1);
  for (std::int64_t x = 0; x < 4000; x += 20)
    for (std::int64_t y = 0; y < 4000; y += 20)
      ground.push_back({651000000 + x, 661000000 + y, static_cast<std::int64_t>(rng.below(4))});
  const FacadesOutcome out = run_wall(ground, 0, false);
  EXPECT_EQ(out.code, 3);
  EXPECT_TRUE(out.facades.empty());
  EXPECT_EQ(out.record["counts"]["facades"]["facades"], 0);
}

}  // namespace
}  // namespace ilot
