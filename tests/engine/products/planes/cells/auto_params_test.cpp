// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/auto_params.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/oriented_sets.h"

namespace ilot {
namespace {

Sampling sampling_of(const test::OrientedSet& set) {
  return measure_sampling(build_neighbour_index(set.view().points));
}

// Points scattered without order, one on average per step^2, on a plane that leans by a third.
test::OrientedSet scattered(double step, double noise, std::uint64_t key) {
  const Vec3 u = (1 / norm({3, 0, 1})) * Vec3{3, 0, 1}, v{0, 1, 0};
  const Vec3 n = cross(u, v);
  test::OrientedSetBuilder b(key);
  Rng rng(key + 1);
  constexpr int kCount = 10000;
  const double edge = step * std::sqrt(static_cast<double>(kCount));
  for (int i = 0; i < kCount; ++i)
    b.add(Vec3{1000, 1000, 1000} + edge * rng.uniform() * u + edge * rng.uniform() * v + noise * test::bell(rng) * n,
          n);
  return b.build();
}

TEST(AutoParams, StepAndNoiseOfPlanesAreRecovered) {
  for (const double step : {20.0, 100.0})
    for (const double noise : {2.0, 10.0}) {
      if (noise > step / 4) continue;  // neighbourhoods would no longer be flat
      const Sampling s = sampling_of(scattered(step, noise, 1));
      EXPECT_NEAR(s.step, step, 0.15 * step) << noise;
      EXPECT_NEAR(s.noise, noise, 0.15 * noise) << step;
    }
}

TEST(AutoParams, AGridOfScanLinesToo) {
  test::OrientedSetBuilder b(5);
  b.add(test::Patch{{1000, 1000, 1000}, {1, 0, 0}, {0, 1, 0}, 100, 100, 50, 5});
  const Sampling s = sampling_of(b.build());
  EXPECT_NEAR(s.step, 50, 7.5);
  EXPECT_NEAR(s.noise, 5, 0.75);
}

TEST(AutoParams, FewOrCoincidingPointsMeasureNothing) {
  test::OrientedSetBuilder few(1), same(2);
  for (int i = 0; i < 15; ++i) few.add({10.0 * i, 5, 5}, {0, 0, 1});
  for (int i = 0; i < 1000; ++i) same.add({5, 5, 5}, {0, 0, 1});
  EXPECT_EQ(sampling_of(few.build()).step, 0);
  EXPECT_EQ(measure_sampling(build_neighbour_index({})).step, 0);
  const Sampling s = sampling_of(same.build());
  EXPECT_EQ(s.step, 0);
  EXPECT_EQ(s.noise, 0);
  const PlaneParams p = choose_plane_params({}, s, SeenFrom::air, 0.001, 1000);
  EXPECT_EQ(p.epsilon, 3);
  EXPECT_GE(p.connectivity, 1);
}

TEST(AutoParams, EpsilonAndConnectivityStayWithinTheirBounds) {
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {40, 10}, SeenFrom::air, 0.001, 1000).epsilon, 35);
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {400, 10}, SeenFrom::air, 0.001, 1000).epsilon, 100);
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {4, 0.1}, SeenFrom::air, 0.001, 1000).epsilon, 3);
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {40, 1000}, SeenFrom::air, 0.001, 1000).epsilon, 500);
  EXPECT_EQ(choose_plane_params({}, {40, 10}, SeenFrom::air, 0.001, 1000).connectivity, 160);
  EXPECT_EQ(choose_plane_params({}, {40, 10}, SeenFrom::ground, 0.001, 1000).connectivity, 240);
  EXPECT_EQ(choose_plane_params({}, {1e9, 10}, SeenFrom::air, 0.001, 1000).connectivity, 1000);
}

TEST(AutoParams, TheSmallestPlaneIsAnAreaWithinBounds) {
  const auto points = [](double step_m, SeenFrom from) {
    return choose_plane_params({}, {step_m / 0.001, 1}, from, 0.001, 100000).min_points;
  };
  EXPECT_EQ(points(0.1, SeenFrom::air), 120u);   // 100 points a square metre
  EXPECT_EQ(points(0.25, SeenFrom::air), 20u);   // 16
  EXPECT_EQ(points(0.5, SeenFrom::air), 12u);    // 4: few points make no plane, however large
  EXPECT_EQ(points(0.02, SeenFrom::air), 200u);  // the ground below a scanner, maybe, where small faces count too
  EXPECT_EQ(points(0.01, SeenFrom::ground), 50u);
  EXPECT_EQ(points(0.02, SeenFrom::ground), 30u);
  EXPECT_EQ(points(0.002, SeenFrom::ground), 200u);
  EXPECT_EQ(points(0, SeenFrom::ground), 200u);
}

TEST(AutoParams, NormalsSeparateFacesWhereEpsilonIsWide) {
  const auto angle = [](double step, double noise, SeenFrom from) {
    return choose_plane_params({}, {step, noise}, from, 0.001, 1000).normal_angle;
  };
  EXPECT_EQ(angle(300, 10, SeenFrom::air), 25);
  EXPECT_NEAR(angle(500, 50, SeenFrom::air), 25 * (125.0 * 125) / (175.0 * 175), 1e-12);
  EXPECT_EQ(angle(300, 100, SeenFrom::air), 10);
  EXPECT_EQ(angle(300, 100, SeenFrom::ground), 25);
}

TEST(AutoParams, WallsAreSeenFromTheGround) {
  const PackedNormal up{0, 0, 32767, 0}, level{32767, 0, 0, 0}, none{0, 0, 0, 0};
  EXPECT_EQ(seen_from({}), SeenFrom::air);
  EXPECT_EQ(seen_from(std::vector<PackedNormal>{up, up, up, level}), SeenFrom::air);
  EXPECT_EQ(seen_from(std::vector<PackedNormal>{up, up, level, none, none}), SeenFrom::ground);
}

TEST(AutoParams, SettingsAreTakenAsTheyAre) {
  PlanesSettings settings;
  settings.epsilon = 0.02;
  settings.connectivity = 0.5;
  settings.min_points = 7;
  settings.normal_angle = 60;
  const PlaneParams p = choose_plane_params(settings, {40, 10}, SeenFrom::air, 0.001, 100);
  EXPECT_DOUBLE_EQ(p.epsilon, 20);
  EXPECT_EQ(p.connectivity, 500);
  EXPECT_EQ(p.min_points, 7u);
  EXPECT_EQ(p.normal_angle, 60);
}

}  // namespace
}  // namespace ilot
