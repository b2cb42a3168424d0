// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/sampling_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/plane_sets.h"

namespace ilot {
namespace {

constexpr double kStep = 5e-4;

Vec3 direction(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

Vec3 hit(const Plane& plane, Vec3 from, Vec3 ray) {
  return from + (-signed_distance(plane, from) / dot(plane.n, ray)) * ray;
}

// The cell's diagonals from four rays, with the maths library.
double cell_diagonal(const Plane& plane, Vec3 from, double azimuth, double elevation) {
  const double h = kStep / 2;
  const auto at = [&](double a, double e) { return hit(plane, from, direction(azimuth + a * h, elevation + e * h)); };
  return std::max(norm(at(1, 1) - at(-1, -1)), norm(at(1, -1) - at(-1, 1)));
}

TEST(PredictedStep, StraightAheadItIsTheDiagonalOfASquare) {
  const Plane wall{{-1, 0, 0}, 100};  // x = 100
  const Scanner station{{0, 0, 0}, {0, 0, 1}, kStep, kStep};
  EXPECT_NEAR(predicted_step(station, wall, {100, 0, 0}), std::sqrt(2.0) * 0.05, 1e-7);
  EXPECT_NEAR(documented_step(station, wall, {100, 0, 0}), std::sqrt(2.0) * 0.05, 1e-12);
}

TEST(PredictedStep, EqualsTheRaysCellForAnyPlaneAndDirection) {
  Rng rng(4);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 n = direction(6.28 * rng.uniform(), 3.1 * (rng.uniform() - 0.5));
    const Plane plane{n, 5 + 50 * rng.uniform()};
    const double azimuth = 6.28 * rng.uniform(), elevation = 2.8 * (rng.uniform() - 0.5);
    const Scanner station{{1, -2, 0.5}, {0, 0, 1}, kStep, kStep};
    const double closing = -dot(n, direction(azimuth, elevation)) * signed_distance(plane, station.position);
    if (closing < 0.05 * std::abs(signed_distance(plane, station.position))) continue;
    ++met;
    const double expected = cell_diagonal(plane, station.position, azimuth, elevation);
    const double step = predicted_step(station, plane, hit(plane, station.position, direction(azimuth, elevation)));
    // Second order in the step over the cosine: 5e-4 / 0.05 squared, a few times.
    EXPECT_NEAR(step, expected, 1e-3 * expected);
  }
  EXPECT_GT(met, 1000);
}

// A raster of rays on a slanting wall: as many points fall into a window as its density says.
TEST(PredictedDensity, IsThatOfTheRaysOnAnyPlane) {
  const double length = std::sqrt(0.8 * 0.8 + 0.5 * 0.5 + 0.3 * 0.3);
  const Plane wall{{-0.8 / length, 0.5 / length, 0.3 / length}, 20};
  const Scanner station{{1, 2, 0}, {0, 0, 1}, 0.002, 0.001};
  const Vec3 middle = hit(wall, station.position, direction(0.1, 0.2));
  int inside = 0;
  for (int a = -400; a <= 400; ++a)
    for (int e = -800; e <= 800; ++e)
      inside += norm(hit(wall, station.position, direction(0.1 + 0.002 * a, 0.2 + 0.001 * e)) - middle) < 0.8;
  const double expected = inside / (M_PI * 0.8 * 0.8);
  ASSERT_GT(inside, 500);
  // The density changes over the disc and its edge cuts cells: a few per cent of either.
  EXPECT_NEAR(predicted_density(station, wall, middle), expected, 0.05 * expected);
  const std::vector<Scanner> twice{station, station};
  EXPECT_DOUBLE_EQ(predicted_density(twice, wall, middle), 2 * predicted_density(station, wall, middle));
  EXPECT_EQ(predicted_density(station, wall, station.position), 0);
}

TEST(PredictedStep, TheDocumentsFormulaIsAQuarterShortAt45Degrees) {
  const Plane wall{{-1, 0, 0}, 10};
  const Scanner station{{0, 0, 0}, {0, 0, 1}, kStep, kStep};
  const Vec3 p{10, 10, 10 * std::sqrt(2.0)};
  EXPECT_NEAR(documented_step(station, wall, p) / predicted_step(station, wall, p), 0.74, 0.01);
}

TEST(PredictedStep, TheSmallestOfManyAndNothingBehind) {
  const Plane wall{{-1, 0, 0}, 10};
  const Scanner near{{5, 0, 0}, {0, 0, 1}, kStep, kStep}, far{{0, 0, 0}, {0, 0, 1}, kStep, kStep};
  const std::vector<Scanner> both{far, near};
  EXPECT_EQ(predicted_step(both, wall, {10, 1, 0}), predicted_step(near, wall, {10, 1, 0}));
  EXPECT_TRUE(std::isinf(predicted_step(std::span<const Scanner>{}, wall, {10, 1, 0})));
  EXPECT_TRUE(std::isinf(predicted_step(Scanner{{10, 0, 0}, {0, 0, 1}, kStep, kStep}, wall, {10, 1, 0})));
  EXPECT_TRUE(std::isinf(predicted_step(far, wall, {0, 0, 0})));
}

TEST(PredictedStep, TurnsWithTheScanner) {
  const Plane wall{{-1, 0, 0}, 10};
  const Scanner up{{0, 0, 0}, {0, 0, 1}, kStep, 2 * kStep}, lying{{0, 0, 0}, {0, 1, 0}, kStep, 2 * kStep};
  EXPECT_NEAR(predicted_step(up, wall, {10, 3, 7}), predicted_step(lying, wall, {10, 7, 3}), 1e-12);
}

TEST(MeasuredSteps, OfARasterAreItsDiagonal) {
  std::vector<Point2> points;
  for (std::int32_t x = 0; x < 20; ++x)
    for (std::int32_t y = 0; y < 20; ++y) points.push_back({100 * x, 100 * y});
  const MeasuredSteps m = measured_steps(points, 6, 10000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool inside = points[i].x > 0 && points[i].x < 1900 && points[i].y > 0 && points[i].y < 1900;
    if (inside) {
      EXPECT_NEAR(m.step[i], 141.4, 14.1);
      EXPECT_EQ(m.reach2[i], 20000);
    }
  }
}

TEST(MeasuredSteps, EqualBruteForce) {
  constexpr int kNeighbours = 6;
  constexpr std::int64_t kFarthest = 500000;
  for (const auto& set : test::plane_sets(120, 3)) {
    if (set.name == "far" || set.name == "corners" || set.name == "clusters" || set.name == "near circle") continue;
    SCOPED_TRACE(set.name);
    const MeasuredSteps m = measured_steps(set.points, kNeighbours, kFarthest);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      std::vector<Point2> places = set.points;
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      std::vector<std::int64_t> d2;
      for (const Point2 p : places) d2.push_back(squared_distance(p, set.points[i]));
      std::sort(d2.begin(), d2.end());
      const bool enough = d2.size() > kNeighbours && d2[kNeighbours] <= kFarthest * kFarthest;
      EXPECT_EQ(m.reach2[i], enough ? d2[kNeighbours] : -1);
      const double used = static_cast<double>(enough ? d2[kNeighbours] : kFarthest * kFarthest);
      EXPECT_FLOAT_EQ(m.step[i], static_cast<float>(std::sqrt(2 * M_PI * used / kNeighbours)));
    }
  }
  EXPECT_TRUE(measured_steps({}, 6, 100).step.empty());
}

}  // namespace
}  // namespace ilot
