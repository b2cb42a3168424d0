// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/auto_params.h"

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
  const PlaneParams p = choose_plane_params({}, s, 0.001, 1000);
  EXPECT_EQ(p.epsilon, 3);
  EXPECT_GE(p.connectivity, 1);
}

TEST(AutoParams, EpsilonAndConnectivityStayWithinTheirBounds) {
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {40, 10}, 0.001, 1000).epsilon, 35);
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {400, 10}, 0.001, 1000).epsilon, 100);
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {4, 0.1}, 0.001, 1000).epsilon, 3);
  EXPECT_DOUBLE_EQ(choose_plane_params({}, {40, 1000}, 0.001, 1000).epsilon, 500);
  EXPECT_EQ(choose_plane_params({}, {40, 10}, 0.001, 1000).connectivity, 120);
  EXPECT_EQ(choose_plane_params({}, {1e9, 10}, 0.001, 1000).connectivity, 1000);
}

TEST(AutoParams, SettingsAreTakenAsTheyAre) {
  PlanesSettings settings;
  settings.epsilon = 0.02;
  settings.connectivity = 0.5;
  settings.min_points = 7;
  settings.normal_angle = 60;
  const PlaneParams p = choose_plane_params(settings, {40, 10}, 0.001, 100);
  EXPECT_DOUBLE_EQ(p.epsilon, 20);
  EXPECT_EQ(p.connectivity, 500);
  EXPECT_EQ(p.min_points, 7u);
  EXPECT_NEAR(p.min_cos, 0.5, 1e-15);
}

}  // namespace
}  // namespace ilot
