// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/facade_ransac.h"

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

constexpr double kTurn = 0.017453292519943295;

// A facade that faces `azimuth`: wall, a joint 20 mm behind it, a return across it, a floor and an inclined apron.
struct Facade {
  test::OrientedSet set;
  Vec3 normal;
};

Facade make_facade(double azimuth, std::uint64_t key) {
  const Vec3 n{std::cos(azimuth * kTurn), std::sin(azimuth * kTurn), 0}, along{-n.y, n.x, 0}, up{0, 0, 1};
  const Vec3 o{10000, 10000, 1000};
  test::OrientedSetBuilder b(key);
  b.add(test::Patch{o, along, up, 120, 80, 10, 1});
  b.add(test::Patch{o + 1200.0 * along - 20.0 * n, along, up, 50, 80, 10, 1});
  b.add(test::Patch{o + 1700.0 * along, up, n, 80, 60, 10, 1});
  b.add(test::Patch{o, n, along, 60, 60, 10, 1});
  const double c = std::cos(40 * kTurn), s = std::sin(40 * kTurn);
  b.add(test::Patch{o + 900.0 * up, along, c * up + s * n, 100, 40, 10, 1});
  return {b.build(), n};
}

FacadeRansacParams facade_params(std::uint64_t key) {
  FacadeRansacParams p;
  p.epsilon = 5;
  p.inclined_gap = 20;
  p.connectivity = 40;
  p.key = key;
  return with_degrees(p, 18, 72, 1.8);
}

TEST(FacadeDirection, IsFoundForAnyAzimuth) {
  for (const double azimuth : {0.0, 0.4, 17.0, 45.0, 89.9, 90.0, 123.4, 179.8, 200.0, 333.0}) {
    const Facade f = make_facade(azimuth, 3);
    const FacadeDirection d = facade_direction(f.set.view());
    ASSERT_TRUE(d.found);
    EXPECT_GT(std::abs(dot(d.normal, f.normal)), 0.999999) << azimuth;
    EXPECT_NEAR(dot(d.normal, d.along), 0, 1e-12);
    EXPECT_NEAR(norm(d.along), 1, 1e-9);
    EXPECT_GT(d.share, 0.5);
  }
}

TEST(FacadeDirection, OppositeNormalsAreOneDirection) {
  test::OrientedSetBuilder b(1);
  for (int i = 0; i < 100; ++i) b.add({100.0 + i, 100, 100}, {i % 2 == 0 ? 1.0 : -1.0, 0, 0});
  const auto d = facade_direction(b.build().view());
  EXPECT_NEAR(std::abs(d.normal.x), 1, 1e-12);
  EXPECT_EQ(d.share, 1);
  test::OrientedSetBuilder floor(1);
  for (int i = 0; i < 100; ++i) floor.add({100.0 + i, 100, 100}, {0, 0, 1});
  EXPECT_FALSE(facade_direction(floor.build().view()).found);
  EXPECT_FALSE(facade_direction({}).found);
}

TEST(FacadeRansac, TakesInclinedAndParallelPlanesAndLeavesTheRest) {
  for (const double azimuth : {0.0, 30.0, 90.0, 140.0}) {
    const Facade f = make_facade(azimuth, 5);
    const FacadeSegments r = facade_ransac(f.set.view(), facade_params(1));
    test::expect_sound(f.set, r.segments, 5, 1000);
    EXPECT_EQ(r.inclined, 1u);
    ASSERT_EQ(r.segments.planes.size(), 3u) << azimuth;
    for (std::size_t p = 1; p < 3; ++p) EXPECT_GT(std::abs(dot(r.segments.planes[p].n, f.normal)), 0.9995);
    const auto count = test::label_sizes(r.segments);
    EXPECT_NEAR(static_cast<double>(count[1]), 4000, 100);
    EXPECT_NEAR(static_cast<double>(count[2]), 9600, 300);
    EXPECT_NEAR(static_cast<double>(count[3]), 4000, 300);
  }
}

TEST(FacadeRansac, RawNumbersAreTheDocumentsAndDegreesAreSines) {
  const auto raw = with_raw_numbers({}), degrees = with_degrees({}, 11.536959, 53.130102, 1.145992);
  EXPECT_EQ(raw.parallel_sine, 0.02);
  EXPECT_NEAR(raw.inclined_from, degrees.inclined_from, 1e-7);
  EXPECT_NEAR(raw.inclined_to, degrees.inclined_to, 1e-7);
  EXPECT_NEAR(raw.parallel_sine, degrees.parallel_sine, 1e-7);
  EXPECT_NEAR(FacadeRansacParams{}.inclined_from, with_degrees({}, 18, 72, 1.8).inclined_from, 1e-12);
  EXPECT_NEAR(FacadeRansacParams{}.parallel_sine, with_degrees({}, 18, 72, 1.8).parallel_sine, 1e-12);
}

TEST(FacadeRansac, NothingUprightNothingFound) {
  EXPECT_TRUE(facade_ransac({}, facade_params(1)).segments.planes.empty());
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 100}, {1, 0, 0}, {0, 1, 0}, 80, 80, 10, 1});
  const auto set = b.build();
  const auto r = facade_ransac(set.view(), facade_params(1));
  EXPECT_TRUE(r.segments.planes.empty());
  EXPECT_EQ(r.segments.label, std::vector<std::uint32_t>(set.size, 0));
}

}  // namespace
}  // namespace ilot
