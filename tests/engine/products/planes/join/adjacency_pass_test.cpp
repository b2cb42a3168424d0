// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/adjacency_pass.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/products/planes/join/label_pass.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

// Lengths in millimetres.
constexpr std::int64_t kRidge = 16000, kRidgeStep = 60;

struct AdjacentPlanes {
  explicit AdjacentPlanes(const PlaneStore& s) : planes(s.joined.planes) {
    const PassContext context;
    label_pass(s.cloud.store(), s.cells, s.found, s.joined, context);
    std::vector<std::uint32_t> id(planes.size() + 1);
    std::iota(id.begin(), id.end(), 0u);
    adjacency_pass(s.cloud.store(), s.cells, s.found, id, planes, context);
    each_touch(s.cloud.store(), [&](const Touch& touch) { touches.push_back(touch); });
  }
  PlaneNeighbours first() const {
    return neighbours_of(touches[0], planes[touches[0].a - 1], planes[touches[0].b - 1], 0.001, 1);
  }
  std::vector<JoinedPlane> planes;
  std::vector<Touch> touches;
};

std::vector<Index3> gable() {
  std::vector<Index3> points;
  test::add_surface(points, {kRidge - 3000, 4000, 5000}, {6000, 6000, 0}, kRidgeStep, 6,
                    [](double x, double) { return -0.5 * std::abs(x - static_cast<double>(kRidge)); });
  return points;
}

TEST(AdjacencyPass, TheFacesOfAGableMeetInTheRidge) {
  const AdjacentPlanes found{PlaneStore(gable())};
  ASSERT_EQ(found.planes.size(), 2u);
  ASSERT_EQ(found.touches.size(), 1u);
  const PlaneNeighbours n = found.first();
  EXPECT_EQ(n.a, 1u);
  EXPECT_EQ(n.b, 2u);
  EXPECT_EQ(n.touching, Touching::edge);
  EXPECT_NEAR(n.angle_deg, 2 * 26.565, 0.2);
  EXPECT_NEAR(n.place.x, 16, 0.01);
  EXPECT_NEAR(n.place.y, 7, 0.3);
  EXPECT_NEAR(n.place.z, 5, 0.01);
  EXPECT_NEAR(std::abs(n.direction.y), 1, 1e-4);
  EXPECT_GT(n.contact_m, 3);
  EXPECT_LT(n.contact_m, 12);
}

TEST(AdjacencyPass, AStepHasAHeight) {
  std::vector<Index3> points;
  test::add_surface(points, {4000, 4000, 5000}, {6000, 6000, 0}, kRidgeStep, 4,
                    [](double x, double) { return x < 7000 ? 0 : 130; });
  const AdjacentPlanes found{PlaneStore(points)};
  ASSERT_EQ(found.planes.size(), 2u);
  ASSERT_EQ(found.touches.size(), 1u);
  const PlaneNeighbours n = found.first();
  const bool up = found.planes[0].plane.d > found.planes[1].plane.d;  // a is the lower one
  EXPECT_EQ(n.touching, Touching::step);
  EXPECT_NEAR(n.step_m, up ? 0.13 : -0.13, 0.003);
  EXPECT_NEAR(n.place.x, 7, 0.3);
  EXPECT_EQ(norm(n.direction), 0);
}

TEST(AdjacencyPass, PlanesApartDoNotTouch) {
  std::vector<Index3> points;
  test::add_surface(points, {4000, 4000, 5000}, {3000, 6000, 0}, kRidgeStep, 4, [](double, double) { return 0; });
  test::add_surface(points, {9000, 4000, 5400}, {3000, 6000, 0}, kRidgeStep, 4, [](double, double) { return 0; });
  const AdjacentPlanes found{PlaneStore(points)};
  EXPECT_EQ(found.planes.size(), 2u);
  EXPECT_TRUE(found.touches.empty());
}

TEST(AdjacencyPass, DoesNotKnowTheBlocks) {
  const AdjacentPlanes whole{PlaneStore(gable())}, cut{PlaneStore(gable(), {500, 2000, 1})};
  ASSERT_EQ(whole.touches.size(), cut.touches.size());
  for (std::size_t i = 0; i < whole.touches.size(); ++i) {
    EXPECT_EQ(whole.touches[i].length, cut.touches[i].length);
    EXPECT_EQ(norm(whole.touches[i].place - cut.touches[i].place), 0);
  }
}

}  // namespace
}  // namespace ilot
