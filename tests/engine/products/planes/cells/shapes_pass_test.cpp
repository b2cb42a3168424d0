// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/shapes_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/products/planes/cells/plane_methods.h"
#include "engine/products/planes/join/label_pass.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

constexpr double kRadius = 1500;
const Vec3 kCentre{200, 300, 1400};

// A sphere over the corner where eight tiles meet, on a level ground, in millimetres.
std::vector<Index3> ball_on_ground() {
  std::vector<Index3> points;
  test::add_surface(points, {-4000, -4000, 0}, {8000, 8000, 0}, 40, 3, [](double, double) { return -100.0; });
  Rng rng(17);
  constexpr int kPoints = 20000;
  for (int i = 0; i < kPoints; ++i) {  // a spiral: evenly spread
    const double h = 1 - 2 * (i + 0.5) / kPoints, turn = 2.399963 * i, level = std::sqrt(1 - h * h);
    const double r = kRadius + 3 * test::bell(rng);
    points.push_back({std::llround(kCentre.x + r * level * std::cos(turn)),
                      std::llround(kCentre.y + r * level * std::sin(turn)), std::llround(kCentre.z + r * h)});
  }
  return points;
}

Settings curved() {
  Settings settings;
  settings.planes.curved = true;
  return settings;
}

struct ShapesResult {
  JoinedShapes joined;
  std::vector<ShapeTally> tallies;
  std::vector<Index3> where;
  std::vector<std::uint32_t> shape, plane;
};

ShapesResult shapes_of(const PlaneStore& s, const PassContext& context = {}) {
  const Store& store = s.cloud.store();
  label_pass(store, s.cells, s.found, s.joined, context);
  ShapesResult r;
  r.joined = join_shapes(store, s.cells);
  r.tallies = shapes_pass(store, s.cells, r.joined, context);
  r.where = test::positions(store);
  r.shape = test::whole_column(store, columns::kShape);
  r.plane = test::whole_column(store, columns::kPlane);
  return r;
}

TEST(ShapesPass, PartsInEightCellsAreOneSphere) {
  const PlaneStore s(ball_on_ground(), {}, curved());
  ASSERT_GE(s.cells.size(), 8u);
  const ShapesResult r = shapes_of(s);
  ASSERT_EQ(r.joined.shapes.size(), 1u);
  ASSERT_GE(r.joined.of_segment.size(), 8u) << "each cell has its part";
  const JoinedShape& j = r.joined.shapes[0];
  EXPECT_EQ(j.shape.kind, ShapeKind::kSphere);
  EXPECT_NEAR(j.shape.radius, kRadius, 1);
  EXPECT_NEAR(j.shape.origin.x + static_cast<double>(j.anchor.x), kCentre.x, 1);
  EXPECT_NEAR(j.shape.origin.z + static_cast<double>(j.anchor.z), kCentre.z, 1);
  EXPECT_GT(r.tallies[0].points, 19000u);
  EXPECT_LT(r.tallies[0].box.max.z, 2960);
}

TEST(ShapesPass, NoPointIsFartherThanEpsilonOrOnAPlaneToo) {
  const PlaneStore s(ball_on_ground(), {}, curved());
  const ShapesResult r = shapes_of(s);
  std::uint64_t labelled = 0;
  double squares = 0;
  for (std::size_t i = 0; i < r.where.size(); ++i) {
    if (r.shape[i] == 0) continue;
    ++labelled;
    EXPECT_EQ(r.plane[i], 0u);
    const JoinedShape& j = r.joined.shapes[r.shape[i] - 1];
    const double d = view_of(j.shape, {static_cast<double>(r.where[i].x - j.anchor.x),
                                       static_cast<double>(r.where[i].y - j.anchor.y),
                                       static_cast<double>(r.where[i].z - j.anchor.z)})
                         .distance;
    EXPECT_LE(std::abs(d), j.epsilon);
    squares += d * d / (j.epsilon * j.epsilon);
  }
  ASSERT_FALSE(r.tallies.empty());
  EXPECT_EQ(labelled, r.tallies[0].points);
  EXPECT_NEAR(static_cast<double>(r.tallies[0].squared_errors) * kErrorUnit, squares, 1e-5 * squares);
}

TEST(ShapesPass, BlocksDoNotShow) {
  const ShapesResult a = shapes_of(PlaneStore(ball_on_ground(), {}, curved()));
  const ShapesResult b = shapes_of(PlaneStore(ball_on_ground(), {1500, 1u << 20, 1}, curved()));
  EXPECT_EQ(a.where, b.where);
  EXPECT_EQ(a.shape, b.shape);
  ASSERT_EQ(a.tallies.size(), b.tallies.size());
  EXPECT_EQ(a.tallies[0].content_id, b.tallies[0].content_id);
  EXPECT_EQ(a.tallies[0].squared_errors, b.tallies[0].squared_errors);
  EXPECT_EQ(a.joined.shapes[0].shape.radius, b.joined.shapes[0].shape.radius);
}

TEST(ShapesPass, OnlyPointsThatAreAskedFor) {
  PassContext context;
  context.wanted = [](Index3 p) { return p.x >= 0; };
  const ShapesResult r = shapes_of(PlaneStore(ball_on_ground(), {}, curved()), context);
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < r.where.size(); ++i) {
    labelled += r.shape[i] != 0;
    EXPECT_TRUE(r.shape[i] == 0 || r.where[i].x >= 0);
  }
  EXPECT_GT(labelled, 5000u);
}

// Two walls and the ground: edges are no thin cylinders.
TEST(ShapesPass, NothingCurvedIsFoundWhereAllIsFlat) {
  std::vector<Index3> points;
  test::add_surface(points, {200, 200, 0}, {6000, 6000, 0}, 30, 3, [](double, double) { return 300.0; });
  Rng rng(5);
  for (std::int64_t a = 200; a < 6200; a += 30)
    for (std::int64_t z = 300; z < 4000; z += 30) {
      const auto noise = [&] { return static_cast<std::int64_t>(std::nearbyint(3 * test::bell(rng))); };
      points.push_back({a, 6200 + noise(), z});
      points.push_back({6200 + noise(), a, z});
    }
  const PlaneStore s(points, {}, curved());
  EXPECT_TRUE(join_shapes(s.cloud.store(), s.cells).shapes.empty());
  EXPECT_EQ(s.joined.planes.size(), 3u);
}

// An upright and a level bar, each with too few points for a shape: a cone of 45 degrees touches both along a line.
TEST(ShapesPass, TwoPlanesThatMeetAreNoCone) {
  std::vector<Index3> points;
  Rng rng(7);
  constexpr std::int64_t kApart = 20, kWidth = 100, kLength = 1100;
  const auto noise = [&] { return static_cast<std::int64_t>(std::nearbyint(2 * test::bell(rng))); };
  for (std::int64_t across = 0; across < kWidth; across += kApart)
    for (std::int64_t along = 0; along < kLength; along += kApart) {
      const std::int64_t x = 500 + across + static_cast<std::int64_t>(rng.below(kApart / 2));
      points.push_back({x, 3000 + noise(), 500 + along});
      points.push_back({x, 3000 - along, 500 + noise()});
    }
  const PlaneStore s(points, {}, curved());
  EXPECT_TRUE(join_shapes(s.cloud.store(), s.cells).shapes.empty());
}

TEST(ShapesPass, AreLookedForByThemselvesInDenseScansAlone) {
  PlanesSettings settings;
  EXPECT_TRUE(wants_curved(settings, 0.05)) << "300 points on 0.75 m2";
  EXPECT_FALSE(wants_curved(settings, 0.06));
  EXPECT_FALSE(wants_curved(settings, 0)) << "nothing measured";
  settings.method = PlaneMethod::shape_ransac;
  EXPECT_FALSE(wants_curved(settings, 0.05)) << "who names a method asks for planes";
  settings.curved = true;
  EXPECT_TRUE(wants_curved(settings, 0.5));
}

}  // namespace
}  // namespace ilot
