// SPDX-License-Identifier: Apache-2.0
// Trees and kerbs of a run over a street whose truth is known exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/deliverables/maps/street_map.h"
#include "engine/model/street_areas.h"
#include "ilot/streets.h"
#include "tests/engine/products/streets/street_runs.h"

namespace ilot {
namespace {

constexpr std::int64_t kMapX = 700000000, kMapY = 660000000;
constexpr double kHeight = 0.12, kTreeX = 12.03, kTreeY = 9.04, kTop = 8.0, kCrown = 2.0;

// 30 m of road and pavement with a kerb at y = 7 m and a slope of 2 %, a point each 4 cm; a tree on the pavement; the
// pixels of the tiles' border are at multiples of 25.6 m, so the kerb crosses one. A box hides the kerb for 4 m.
std::vector<Index3> street_with_a_tree() {
  Rng rng(3);
  std::vector<Index3> points;
  const auto ground = [](double x, double y) { return 30 + 0.02 * x + (y < 7 ? 0.0 : kHeight + 0.02 * (y - 7)); };
  const auto add = [&](double x, double y, double z) {
    points.push_back({kMapX + std::llround(1000 * x), kMapY + std::llround(1000 * y), std::llround(1000 * z)});
  };
  for (double x = 0; x < 30; x += 0.04)
    for (double y = 0; y < 12; y += 0.04) {
      const double u = x + 0.03 * rng.uniform(), v = y + 0.03 * rng.uniform();
      const bool hidden = u > 18 && u < 22 && v > 5 && v < 7.5;
      if (!hidden) add(u, v, ground(u, v) + 0.008 * (rng.uniform() - 0.5));
    }
  for (double x = 18; x < 22; x += 0.04)
    for (double y = 5.2; y < 6.9; y += 0.04) add(x, y, ground(x, 5) + 1.45);
  const double foot = ground(kTreeX, kTreeY);
  for (double h = 0; h < 4; h += 0.03)  // the side of the trunk to the road
    for (int i = 0; i <= 12; ++i) {
      const double a = (180 + 15 * i) * 3.14159265358979 / 180;
      add(kTreeX + 0.15 * std::cos(a), kTreeY + 0.15 * std::sin(a), foot + h);
    }
  for (int i = 0; i < 20000; ++i) {
    Vec3 p{2, 2, 2};
    while (dot(p, p) > 1) p = {2 * rng.uniform() - 1, 2 * rng.uniform() - 1, 2 * rng.uniform() - 1};
    add(kTreeX + kCrown * p.x, kTreeY + kCrown * p.y, foot + 0.5 * (kTop + 3.0) + 0.5 * (kTop - 3.0) * p.z);
  }
  return points;
}

struct MapOutcome {
  StreetPlan plan;
  std::string trees, kerbs;  // bytes of the files
};

MapOutcome run_street(const std::vector<Index3>& points, const std::function<void(RunOptions&)>& change = {}) {
  const TemporaryFolder folder;
  const std::filesystem::path out = test::run_mapped(folder, points, change).out;
  return {read_streets(out), test::file_bytes(out / "streets" / "trees.gpkg"),
          test::file_bytes(out / "streets" / "kerbs.gpkg")};
}

TEST(StreetMap, TheTreeIsWhereItStands) {
  const StreetPlan plan = run_street(street_with_a_tree()).plan;
  ASSERT_EQ(plan.trees.size(), 1u);
  const StreetTree& tree = plan.trees[0];
  EXPECT_TRUE(tree.trunk_seen);
  EXPECT_NEAR(tree.position.x, kMapX / 1000.0 + kTreeX, 0.05);
  EXPECT_NEAR(tree.position.y, kMapY / 1000.0 + kTreeY, 0.05);
  EXPECT_NEAR(tree.height_m, kTop, 0.1);
  EXPECT_NEAR(tree.crown_radius_m, kCrown, 0.3);
  EXPECT_NEAR(tree.trunk_radius_m, 0.15, 0.03);
  EXPECT_GT(tree.crown_base_m, 2.4);
  EXPECT_LT(tree.crown_base_m, 4.5);
  EXPECT_LT(tree.unseen_share, 0.1);
}

TEST(StreetMap, TheKerbIsOnItsEdgeAndTheBoxHidesAPartOfIt) {
  const StreetPlan plan = run_street(street_with_a_tree()).plan;
  double seen = 0, bridged = 0;
  for (const StreetKerb& kerb : plan.kerbs) {
    (kerb.seen ? seen : bridged) += kerb.length_m;
    for (std::size_t i = 0; i < kerb.line.size(); ++i) {
      EXPECT_NEAR(kerb.line[i].y, kMapY / 1000.0 + 7, 0.04);
      EXPECT_NEAR(kerb.heights_m[i], kHeight, 0.012);
      EXPECT_NEAR(kerb.line[i].z, 30 + 0.02 * (kerb.line[i].x - kMapX / 1000.0) + kHeight, 0.012);
    }
    EXPECT_GT(kerb.line.back().x, kerb.line.front().x) << "the pavement is on the left, in the north";
  }
  // 30 m without the hidden 4; each of the four ends is short by a window and a link at most.
  EXPECT_GT(seen, 26 - 4 * 1.0);
  EXPECT_LT(seen, 26.5);
  EXPECT_GT(bridged, 4);
  EXPECT_LT(bridged, 4 + 2 * 1.0);
}

// The same bytes for any number of threads, length of blocks, order of points, and memory.
TEST(StreetMap, NothingDependsOnThreadsBlocksOrderOrMemory) {
  std::vector<Index3> points = street_with_a_tree();
  const MapOutcome one = run_street(points, [](RunOptions& o) { o.threads = 1; });
  ASSERT_FALSE(one.trees.empty());
  ASSERT_FALSE(one.kerbs.empty());
  const MapOutcome three = run_street(points, [](RunOptions& o) { o.threads = 3; });
  EXPECT_EQ(three.trees, one.trees);
  EXPECT_EQ(three.kerbs, one.kerbs);
  const MapOutcome blocks = run_street(points, [](RunOptions& o) {
    o.settings.index.block_points = 20000;
    o.memory_bytes = std::uint64_t{256} << 20;
  });
  EXPECT_EQ(blocks.trees, one.trees);
  EXPECT_EQ(blocks.kerbs, one.kerbs);
  std::reverse(points.begin(), points.end());
  const MapOutcome reversed = run_street(points);
  EXPECT_EQ(reversed.trees, one.trees);
  EXPECT_EQ(reversed.kerbs, one.kerbs);
}

// The sheet names every kind that is on it and no other, and numbers each object.
TEST(StreetMap, TheSheetHasALegend) {
  StreetPlan plan;
  StreetObject car;
  car.id = 17, car.label = PointLabel::car, car.class_name = "car", car.middle = {5, 5, 0}, car.length_m = 4;
  plan.objects = {car, car};
  plan.objects[1].id = 23, plan.objects[1].middle = {9, 5, 0};
  const std::string sheet = street_sheet_svg(plan, 1);
  for (const char* text : {">car (2)<", ">17<", ">23<", ">North<", ">20 m<"})
    EXPECT_NE(sheet.find(text), std::string::npos) << text;
  for (const char* text : {"tree", "kerb", "pavement", "houses"})
    EXPECT_EQ(sheet.find(text), std::string::npos) << text;
  EXPECT_NE(street_sheet_svg({}, 1).find(">North<"), std::string::npos) << "an empty plan";
}

// The page is as wide as the longest line of its legend needs.
TEST(StreetMap, LongLinesOfTheLegendAreOnThePage) {
  const auto width = [](const std::string& svg) {
    double size[4] = {};
    const int read = std::sscanf(svg.c_str() + svg.find("viewBox=\"") + 9, "%lf %lf %lf", &size[0], &size[1], &size[2]);
    return read == 3 ? size[2] : 0;
  };
  const std::vector<std::string> notes{"short"}, longer{std::string(60, 'n')};
  EXPECT_EQ(width(street_sheet_svg({}, 1, notes)), width(street_sheet_svg({}, 1, std::vector<std::string>{"shorter"})));
  EXPECT_GT(width(street_sheet_svg({}, 1, longer)), width(street_sheet_svg({}, 1, notes)) * 1.2);
}

// Two areas far apart are two sheets, which say so. Things a kilometre apart are on one.
TEST(StreetMap, AreasFarApartAreSheetsOfTheirOwn) {
  StreetPlan plan;
  StreetObject car;
  car.id = 1, car.label = PointLabel::car, car.class_name = "car", car.middle = {5, 5, 0}, car.length_m = 4;
  plan.objects = {car, car, car};
  plan.objects[1].id = 2, plan.objects[1].middle = {388000, 5, 0};
  plan.objects[2].id = 3, plan.objects[2].middle = {5, 1000, 0};
  StreetTree tree;
  tree.id = 1, tree.position = {388004, 9, 0}, tree.crown_radius_m = 2;
  plan.trees = {tree};
  const TemporaryFolder folder;
  write_street_map(folder.path(), plan, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "streets.svg"));
  const std::string first = test::file_bytes(folder.path() / "streets_1.svg"),
                    second = test::file_bytes(folder.path() / "streets_2.svg");
  for (const char* text : {">car (2)<", ">1<", ">3<", ">Sheet 1 of 2: the areas are far apart.<"})
    EXPECT_NE(first.find(text), std::string::npos) << text;
  for (const char* text : {">car (1)<", ">2<", ">tree, its crown (1)<", ">Sheet 2 of 2: the areas are far apart.<"})
    EXPECT_NE(second.find(text), std::string::npos) << text;
  plan.objects.erase(plan.objects.begin() + 1);
  plan.trees.clear();
  write_street_map(folder.path(), plan, 1);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "streets.svg"));
  EXPECT_EQ(street_areas({}, 1).size(), 1u) << "an empty plan";
}

// What is inside of an area is as without it, though the points around it lose their labels.
TEST(StreetMap, AnAreaCutsNothingOfATreeThatStandsInIt) {
  const MapOutcome whole = run_street(street_with_a_tree());
  const MapOutcome part = run_street(street_with_a_tree(), [](RunOptions& o) {
    o.area = Area{kMapX / 1000.0 + 8, kMapY / 1000.0, kMapX / 1000.0 + 13, kMapY / 1000.0 + 12, {}};
  });
  ASSERT_EQ(whole.plan.trees.size(), 1u);
  ASSERT_EQ(part.plan.trees.size(), 1u);
  EXPECT_NEAR(part.plan.trees[0].position.x, whole.plan.trees[0].position.x, 1e-9);
  EXPECT_NEAR(part.plan.trees[0].height_m, whole.plan.trees[0].height_m, 1e-9);
  for (const StreetKerb& kerb : part.plan.kerbs)
    for (const Vec3& p : kerb.line) {
      EXPECT_GE(p.x, kMapX / 1000.0 + 7.9);
      EXPECT_LE(p.x, kMapX / 1000.0 + 13.1);
    }
}

}  // namespace
}  // namespace ilot
