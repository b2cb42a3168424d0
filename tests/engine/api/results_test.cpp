// SPDX-License-Identifier: Apache-2.0
// What writers of the engine write, the public readers read.
#include <gtest/gtest.h>

#include "engine/deliverables/layers/kerbs_gpkg.h"
#include "engine/deliverables/layers/planes_gpkg.h"
#include "engine/deliverables/layers/streets_gpkg.h"
#include "engine/deliverables/layers/trees_gpkg.h"
#include "engine/deliverables/solids/city_json.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/planes_csv.h"
#include "engine/deliverables/tables/planes_neighbours_csv.h"
#include "ilot/error.h"
#include "ilot/facades.h"
#include "ilot/planes.h"
#include "ilot/roofs.h"
#include "ilot/run.h"
#include "ilot/streets.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(PublicResults, Planes) {
  const TemporaryFolder folder;
  std::vector<Segment> segments(2);
  for (std::uint32_t i = 0; i < 2; ++i) {
    segments[i].id = i + 1;
    segments[i].content_id = 0xfedcba9876543210ull + i;
    segments[i].plane = {{0, 0, 1}, -7.25 - i};
    segments[i].points = 5000000000ull;
    segments[i].area_m2 = 12.5;
  }
  write_planes_csv(folder.path() / "planes.csv", segments);
  PlanesNeighboursCsv pairs(folder.path() / "planes_neighbours.csv");
  pairs.add({1, 2, Touching::step, 3.5, 0.25, 1, {1, 2, 3}, {0, 0, 0}});
  pairs.finish();
  PlanesGpkg layer(folder.path() / "planes.gpkg", {});
  const Outline square{1, {{{{0, 0, 7}, {9, 0, 7}, {9, 9, 7}}, {{3, 3, 7}, {3, 4, 7}, {4, 3, 7}}}}};
  layer.add(segments[0], square);
  layer.add(segments[1], {2, {}});
  layer.finish();

  const PlaneSet set = read_planes(folder.path());
  ASSERT_EQ(set.segments.size(), 2u);
  EXPECT_EQ(set.segments[1].content_id, segments[1].content_id);
  EXPECT_EQ(set.segments[1].plane.d, -8.25);
  EXPECT_EQ(set.segments[0].points, 5000000000ull);
  ASSERT_EQ(set.neighbours.size(), 1u);
  EXPECT_EQ(set.neighbours[0].touching, Touching::step);
  EXPECT_EQ(set.neighbours[0].place.z, 3);
  ASSERT_EQ(set.outlines.size(), 2u);
  ASSERT_EQ(set.outlines[0].parts.size(), 1u);
  ASSERT_EQ(set.outlines[0].parts[0].size(), 2u);
  EXPECT_EQ(set.outlines[0].parts[0][1].size(), 3u);
  EXPECT_EQ(set.outlines[0].parts[0][0][1].x, 9);
  EXPECT_TRUE(set.outlines[1].parts.empty());
}

TEST(PublicResults, Roofs) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "roofs");
  Building solid;
  solid.id = "a/\"1\"";
  solid.vertices = {{652000, 6862000, 0}, {652003, 6862000, 0}, {652000, 6862004, 0}, {652000, 6862000, 5}};
  solid.surfaces = {{SurfaceKind::ground, 0, {{0, 2, 1}}},
                    {SurfaceKind::wall, 0, {{0, 1, 3}}},
                    {SurfaceKind::wall, 0, {{0, 3, 2}}},
                    {SurfaceKind::roof, 8, {{1, 2, 3}}}};
  solid.attributes = {{"status", std::string("lod22")}, {"points", std::int64_t{77}}, {"h_roof_max", 5.0}};
  CityJsonParams params;
  params.origin = {600000, 6800000, 0};
  CityJsonWriter writer(folder.path() / "roofs/roofs.city.jsonl", params);
  writer.add(solid);
  writer.finish();

  const std::vector<BuildingModel> models = read_roofs(folder.path());
  ASSERT_EQ(models.size(), 1u);
  EXPECT_EQ(models[0].id, solid.id);
  EXPECT_EQ(models[0].text("status"), "lod22");
  EXPECT_EQ(models[0].number("points"), 77);
  EXPECT_EQ(models[0].number("status"), std::nullopt);
  ASSERT_EQ(models[0].levels.size(), 1u);
  const Building& back = models[0].levels[0];
  EXPECT_EQ(back.lod, "2.2");
  ASSERT_EQ(back.surfaces.size(), 4u);
  EXPECT_EQ(back.surfaces[3].kind, SurfaceKind::roof);
  EXPECT_EQ(back.surfaces[3].plane_id, 8u);
  EXPECT_NEAR(volume_m3(back, 1), 10, 0.01);
  folder.put("roofs/roofs.city.jsonl", "{}\n");
  EXPECT_THROW(read_roofs(folder.path()), Error);
}

TEST(PublicResults, FacadesByNumber) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "facades");
  for (const std::uint32_t id : {2u, 10u, 1u}) {
    Facade facade;
    facade.id = id;
    facade.right = {1, 0, 0};
    facade.up = {0, 0, 1};
    facade.out = {0, -1, 0};
    facade.width_m = id;
    facade.height_m = 3;
    write_facade_json(folder.path() / "facades" / ("facade-00" + std::to_string(id) + ".json"), facade);
  }
  const std::vector<Facade> facades = read_facades(folder.path());
  ASSERT_EQ(facades.size(), 3u);
  EXPECT_EQ(facades[0].id, 1u);
  EXPECT_EQ(facades[2].width_m, 10);
}

TEST(PublicResults, Streets) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "streets");
  StreetPlan plan;
  StreetObject car;
  car.id = 1;
  car.label = PointLabel::car;
  car.class_name = "car";
  car.probability = 0.75;
  car.base = {652001, 6862002, 30};
  car.middle = {652001.5, 6862002.25, 30};
  car.length_m = 4;
  car.width_m = 2;
  car.heading_deg = 30;
  car.points = 1000;
  plan.objects = {car};
  plan.blocks = {{1, 1, {0, 0, 0}, {10, 0, 0}, 10, 15}};
  plan.gaps = {{1, 2, {10, 0, 0}, {12, 0, 0}, 2, 0}};
  write_objects_gpkg(folder.path() / "streets/objects.gpkg", plan, {});
  write_blocks_gpkg(folder.path() / "streets/blocks.gpkg", plan, {});
  EXPECT_TRUE(read_streets(folder.path()).trees.empty()) << "a run of an earlier version";
  plan.trees = {{1, {652003, 6862004, 31}, true, 8.5, 2.25, 3, 0.15, 0.25, 700},
                {2, {652013, 6862004, 31}, false, 5, 1, 2}};
  plan.kerbs = {{1, true, {{0, 0, 1}, {5, 0, 1.5}, {9, 1, 2}}, {0.1, 0.12, 0.14}, 0.12, 9.2},
                {2, false, {{9, 1, 2}, {12, 2, 2}}, {0.14, 0.12}, 0.13, 3.2}};
  write_trees_gpkg(folder.path() / "streets/trees.gpkg", plan, {});
  write_kerbs_gpkg(folder.path() / "streets/kerbs.gpkg", plan, {});
  const StreetPlan back = read_streets(folder.path());
  ASSERT_EQ(back.objects.size(), 1u);
  EXPECT_EQ(back.objects[0].label, PointLabel::car);
  EXPECT_EQ(back.objects[0].points, 1000u);
  EXPECT_EQ(back.objects[0].block, 0u);
  EXPECT_EQ(back.objects[0].base.z, 30);
  EXPECT_NEAR(back.objects[0].middle.x, 652001.5, 1e-6);
  EXPECT_NEAR(back.objects[0].middle.y, 6862002.25, 1e-6);
  ASSERT_EQ(back.blocks.size(), 1u);
  EXPECT_EQ(back.blocks[0].to.x, 10);
  EXPECT_EQ(back.gaps[0].number, 2u);
  ASSERT_EQ(back.trees.size(), 2u);
  EXPECT_TRUE(back.trees[0].trunk_seen);
  EXPECT_FALSE(back.trees[1].trunk_seen);
  EXPECT_EQ(back.trees[0].position.z, 31);
  EXPECT_EQ(back.trees[0].height_m, 8.5);
  EXPECT_EQ(back.trees[0].crown_radius_m, 2.25);
  EXPECT_EQ(back.trees[0].trunk_radius_m, 0.15);
  EXPECT_EQ(back.trees[0].unseen_share, 0.25);
  EXPECT_EQ(back.trees[0].points, 700u);
  ASSERT_EQ(back.kerbs.size(), 2u);
  EXPECT_EQ(back.kerbs[0].line[1].z, 1.5);
  EXPECT_EQ(back.kerbs[0].heights_m, (std::vector<double>{0.1, 0.12, 0.14}));
  EXPECT_FALSE(back.kerbs[1].seen);
}

TEST(PublicResults, MissingOnesAreFaultsOfUse) {
  const TemporaryFolder folder;
  const auto is_usage = [&](const auto& read) {
    try {
      read(folder.path());
    } catch (const Error& fault) {
      return fault.code() == ExitCode::usage;
    }
    return false;
  };
  EXPECT_TRUE(is_usage([](const auto& path) { read_planes(path); }));
  EXPECT_TRUE(is_usage([](const auto& path) { read_roofs(path); }));
  EXPECT_TRUE(is_usage([](const auto& path) { read_facades(path); }));
  EXPECT_TRUE(is_usage([](const auto& path) { read_streets(path); }));
  EXPECT_TRUE(is_usage([](const auto& path) { read_run(path); }));
  folder.put("run.json", "{}");
  EXPECT_THROW(read_run(folder.path()), Error);
  EXPECT_TRUE(is_usage([](const auto& path) {
    RunOptions options;
    options.inputs = {path / "missing.las"};
    options.output = path / "out";
    run(options);
  }));
}

}  // namespace
}  // namespace ilot
