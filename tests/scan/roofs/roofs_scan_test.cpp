// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roofs_scan.h"
#include "tests/support/scan_records.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/pulse_tracer.h"
#include "scan/scanners/scan_record.h"
#include "scan/truth_writer.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kRoofsRecord = 45;

RoofsScan plan_roofs(std::initializer_list<const char*> settings, std::optional<std::uint64_t> points = {}) {
  SceneValues values(roofs_options());
  for (const char* setting : settings) values.set(setting);
  return plan_roofs(values, 3, points);
}

std::vector<std::byte> records_of(const RoofsScan& scan, const RoofTown& town, int threads) {
  std::vector<std::byte> all;
  with_threads(threads, [&] {
    scan_roofs(scan, town,
               [&](std::span<const std::byte> records) { all.insert(all.end(), records.begin(), records.end()); });
  });
  return all;
}

TEST(RoofsScan, SameBytesForAnyNumberOfThreads) {
  const RoofsScan scan = plan_roofs({"scene.buildings=40", "scene.density=3"});
  const RoofTown town = build_roof_town(scan.town);
  const std::vector<std::byte> one = records_of(scan, town, 1);
  EXPECT_GT(one.size() / kRoofsRecord, 40000u);
  for (int threads : {2, 3}) EXPECT_TRUE(records_of(scan, town, threads) == one) << threads;
}

TEST(RoofsScan, AboutAsManyPointsAsAskedFor) {
  for (const char* trees : {"scene.trees=0", "scene.trees=25", "scene.trees=50"}) {
    RoofsScan scan = plan_roofs({"scene.buildings=60", trees}, 150000);
    const RoofTown town = build_roof_town(scan.town);
    scan.flight.density = density_for(town, *scan.points);
    EXPECT_NEAR(static_cast<double>(records_of(scan, town, 2).size() / kRoofsRecord), 150000, 3000) << trees;
  }
  EXPECT_THROW(plan_roofs({"scene.density=3"}, 1000), Error);
}

// Distance along the ray to the nearest flat face or to the ground, by brute force over all polygons.
double nearest_face(const Ray& ray, const RoofTown& town) {
  const Plane ground = town.ground.plane();
  double nearest = -signed_distance(ground, ray.origin) / dot(ground.n, ray.direction);
  for (const RoofBuilding& building : town.buildings) {
    const Vec3 origin = building.frame.to_local(ray.origin);
    const Vec3 direction = building.frame.to_local(ray.origin + ray.direction) - origin;
    for (const RoofFace& face : building.solid.faces) {
      const double rate = dot(face.plane.n, direction);
      if (rate >= 0) continue;
      const double t = -signed_distance(face.plane, origin) / rate;
      if (t > 0 && t < nearest && face_contains(building.solid, face, origin + t * direction)) nearest = t;
    }
  }
  return nearest;
}

TEST(RoofsScan, RaysMeetTheFacesOfTheSolids) {
  const RoofsScan scan = plan_roofs({"scene.buildings=25", "scene.trees=0", "scene.chimneys=1", "scene.density=2"});
  const RoofTown town = build_roof_town(scan.town);
  const RoofsScene scene = make_roofs_scene(town);
  const RayScene rays(scene.solids, town.crowns, {town.area.x1 / 2, town.area.y1 / 2, 50});
  PulseTracer tracer(rays, town.ground.plane());
  const FlightPlan flight(scan.flight, town.ground, 1);
  std::vector<PulseEcho> echoes;
  std::map<RoofPart, int> met;
  flight.for_each_pulse(town.area, [&](Pulse pulse) {
    tracer.trace(pulse.ray, pulse.rng, echoes);
    ASSERT_EQ(echoes.size(), 1u);
    ASSERT_NEAR(echoes[0].range, nearest_face(pulse.ray, town), 1e-6);
    if (echoes[0].from != PulseEcho::From::face) return;
    const Vec3 place = point_at(pulse.ray, echoes[0].range);
    const RoofsScene::Target& target = scene.targets[echoes[0].face];
    const RoofBuilding& building = town.buildings[target.building];
    const RoofFace& face = building.solid.faces[face_met(town, target, place)];
    ++met[face.part];
    EXPECT_NEAR(signed_distance(face.plane, building.frame.to_local(place)), 0, 1e-6);
  });
  EXPECT_GT(met[RoofPart::roof], 3000);
  EXPECT_GT(met[RoofPart::wall], 200);
  EXPECT_EQ(met[RoofPart::floor], 0);
}

class RoofsFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("ilot_roofs_test_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    path_ = folder_ / "roofs.las";
    ScanRequest request{"roofs", SceneValues(roofs_options()), 0, {}, path_};
    request.values.set("scene.density=4");
    counts_ = scan_roofs_scene(request);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static nlohmann::json read(const std::filesystem::path& path) {
    std::ifstream file(path);
    return nlohmann::json::parse(file);
  }

  std::filesystem::path folder_, path_;
  ScanCounts counts_;
};

TEST_F(RoofsFile, PointsLieOnTheirTruePlanes) {
  const nlohmann::json truth = read(truth_path(path_));
  std::map<std::uint32_t, Plane> planes;
  std::map<std::uint32_t, std::uint64_t> declared, counted;
  double roof_area = 0;
  for (const auto& p : truth["planes"]) {
    planes[p["id"]] = {{p["plane"][0], p["plane"][1], p["plane"][2]}, p["plane"][3]};
    declared[p["id"]] = p["points"];
    EXPECT_FALSE(p["polygons"].empty());
    if (p["class"] == "roof") roof_area += p["area_m2"].get<double>();
  }
  EXPECT_GT(roof_area, 445 * 60);
  std::map<std::string, int> roofs;
  std::set<std::uint32_t> faces;
  for (const auto& b : truth["buildings"]) {
    ++roofs[b["roof"]];
    for (std::uint32_t id : b["faces"]) faces.insert(id);
  }
  EXPECT_EQ(roofs["gable"], 128);
  EXPECT_EQ(roofs["hip"], 52);
  EXPECT_EQ(roofs["complex"], 265);

  const auto reader = open_cloud(path_);
  const std::uint64_t n = reader->info().points;
  std::vector<std::byte> records(n * kRoofsRecord);
  std::vector<std::uint8_t> valid(n);
  ASSERT_EQ(reader->read(0, records, valid), n);
  EXPECT_EQ(counts_[0].second, n);
  double squares = 0, across = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const RecordTruth t = truth_of(&records[i * kRoofsRecord]);
    ASSERT_EQ(t.true_plane == 0, t.true_class == 4);
    if (t.true_plane == 0) continue;
    ++counted[t.true_plane];
    const Vec3 p = place_of(&records[i * kRoofsRecord], reader->info().layout) + kSceneOrigin;
    const double distance = signed_distance(planes.at(t.true_plane), p);
    ASSERT_LT(std::abs(distance), 6 * 0.02 + 0.001);
    if (t.true_class == 2) {
      squares += distance * distance;
      ++across;
    }
  }
  // Noise acts along the ray: across a roof never more, and little less where it is flat.
  EXPECT_LT(std::sqrt(squares / across), 0.0202);
  EXPECT_GT(std::sqrt(squares / across), 0.014);
  for (const auto& [id, points] : declared) EXPECT_EQ(counted[id], points) << id;
  // No roof face worth the name goes unseen at this density.
  for (const auto& p : truth["planes"])
    if (p["class"] == "roof" && p["area_m2"].get<double>() > 6) {
      EXPECT_GT(p["points"].get<int>(), 2);
    }
}

// Each solid of the model, as rounded in the file: every edge twice and opposite, rings flat within a millimetre and
// turning outwards, volume positive.
TEST_F(RoofsFile, TheModelIsMadeOfClosedFlatSolids) {
  const nlohmann::json model = read(truth_path(path_).replace_extension(".city.json"));
  EXPECT_EQ(model["version"], "2.0");
  EXPECT_EQ(model["CityObjects"].size(), 445u);
  const double scale = model["transform"]["scale"][0];
  std::vector<Vec3> vertices;
  for (const auto& v : model["vertices"])
    vertices.push_back(scale * Vec3{v[0].get<double>(), v[1].get<double>(), v[2].get<double>()});
  for (const auto& [name, object] : model["CityObjects"].items()) {
    const auto& solid = object["geometry"][0];
    const auto& shell = solid["boundaries"][0];
    EXPECT_EQ(solid["semantics"]["values"][0].size(), shell.size());
    std::map<std::pair<int, int>, int> ways;
    double volume = 0, up = 0;
    std::map<std::string, int> kinds;
    for (std::size_t f = 0; f < shell.size(); ++f) {
      Vec3 area{0, 0, 0};
      const Vec3 anchor = vertices[shell[f][0][0].get<std::size_t>()];
      for (const auto& ring : shell[f])
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const int from = ring[i], to = ring[(i + 1) % ring.size()];
          ++ways[{from, to}];
          area = area + cross(vertices[static_cast<std::size_t>(from)] - anchor,
                              vertices[static_cast<std::size_t>(to)] - anchor);
        }
      const Vec3 normal = (1 / norm(area)) * area;
      for (const auto& ring : shell[f])
        for (const auto& v : ring) EXPECT_LT(std::abs(dot(normal, vertices[v.get<std::size_t>()] - anchor)), 0.001);
      volume += dot(area, anchor - vertices[shell[0][0][0].get<std::size_t>()]) / 6;
      const std::string kind = solid["semantics"]["surfaces"][f]["type"];
      ++kinds[kind];
      if (kind == "RoofSurface") {
        EXPECT_GT(normal.z, 0.2);
      }
      if (kind == "WallSurface") {
        EXPECT_LT(std::abs(normal.z), 1e-3);
      }
      if (kind == "GroundSurface") {
        EXPECT_LT(normal.z, -0.999);
      }
      up += area.z;
    }
    for (const auto& [way, times] : ways) {
      EXPECT_EQ(times, 1) << name;
      EXPECT_EQ((ways.count({way.second, way.first})), 1u) << name;
    }
    EXPECT_GT(volume, 100);
    EXPECT_NEAR(up, 0, 1e-3);
    EXPECT_EQ(kinds["GroundSurface"], 1);
    EXPECT_EQ(kinds["RoofSurface"], object["attributes"]["roof_faces"].get<int>());
  }
}

}  // namespace
}  // namespace ilot::scan
