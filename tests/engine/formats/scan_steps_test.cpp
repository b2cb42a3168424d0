// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/scan_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kAzimuth = 0.0009, kElevation = 0.0006;

// A room of 8 by 6 by 4 m around the scanner, in millimetres as files round it; one ray in five does not come back.
// Columns go round, rows go up from first_row on,
// past the zenith too.
std::vector<GridPoint> scanned_room(std::int64_t columns, std::int64_t rows, double first_row = -0.4) {
  Rng rng(3);
  std::vector<GridPoint> points;
  for (std::int64_t c = 0; c < columns; ++c)
    for (std::int64_t r = 0; r < rows; ++r) {
      if (rng.below(5) == 0) continue;
      const double a = 0.3 + kAzimuth * static_cast<double>(c), e = first_row + kElevation * static_cast<double>(r);
      const Vec3 ray{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
      const double range =
          std::min({4000 / std::abs(ray.x), 3000 / std::abs(ray.y), (ray.z > 0 ? 2300 : 1700) / std::abs(ray.z)});
      points.push_back(
          {r,
           c,
           {std::round(range * ray.x) / 1000, std::round(range * ray.y) / 1000, std::round(range * ray.z) / 1000}});
    }
  return points;
}

std::vector<Vec3> rays_of(const std::vector<GridPoint>& points) {
  std::vector<Vec3> rays;
  for (const GridPoint& p : points) rays.push_back(p.ray);
  return rays;
}

void expect_steps(const AngularSteps& steps, double azimuth, double elevation, double share) {
  EXPECT_NEAR(steps.azimuth, azimuth, share * azimuth);
  EXPECT_NEAR(steps.elevation, elevation, share * elevation);
}

TEST(StepsOfGrid, AreThoseOfTheScanWhateverTheOrder) {
  auto points = scanned_room(60, 1000);
  expect_steps(steps_of_grid(points), kAzimuth, kElevation, 0.02);
  std::reverse(points.begin(), points.end());
  for (std::size_t i = 0; i + 7 < points.size(); i += 5) std::swap(points[i], points[i + 7]);
  expect_steps(steps_of_grid(points), kAzimuth, kElevation, 0.02);
  for (GridPoint& p : points) {
    std::swap(p.row, p.column);
    p.row = -p.row;
  }
  expect_steps(steps_of_grid(points), kAzimuth, kElevation, 0.02);
}

// Half a turn of columns that go up on one side and down on the other.
TEST(StepsOfGrid, ColumnsMayGoOverTheTop) {
  expect_steps(steps_of_grid(scanned_room(40, 5000, -0.2)), kAzimuth, kElevation, 0.02);
}

TEST(StepsOfGrid, UnknownWhereThereIsNoGrid) {
  const auto points = scanned_room(1, 1000);
  EXPECT_EQ(steps_of_grid(points).elevation, 0) << "one column tells one step alone";
  EXPECT_EQ(steps_of_grid({}).azimuth, 0);
  auto same = scanned_room(20, 200);
  for (GridPoint& p : same) p.ray = {1, 2, 3};
  EXPECT_EQ(steps_of_grid(same).azimuth, 0);
  auto bad = scanned_room(20, 200);
  for (GridPoint& p : bad) p.ray = {NAN, 2, INFINITY};
  EXPECT_EQ(steps_of_grid(bad).azimuth, 0);
}

TEST(StepsOfSequence, AreThoseOfTheProfiles) {
  const auto points = scanned_room(60, 1000);
  expect_steps(steps_of_sequence(rays_of(points)), kAzimuth, kElevation, 0.05);
  auto forth_and_back = points;  // every other profile from its end
  for (auto first = forth_and_back.begin(); first != forth_and_back.end();) {
    const auto end =
        std::find_if(first, forth_and_back.end(), [&](const auto& p) { return p.column != first->column; });
    if (first->column % 2 == 1) std::reverse(first, end);
    first = end;
  }
  expect_steps(steps_of_sequence(rays_of(forth_and_back)), kAzimuth, kElevation, 0.05);
  auto rows = points;
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
  expect_steps(steps_of_sequence(rays_of(rows)), kAzimuth, kElevation, 0.05);
}

TEST(StepsOfSequence, UnknownWhereTheOrderIsLost) {
  auto rays = rays_of(scanned_room(60, 1000));
  Rng rng(8);
  for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[rng.below(i)]);
  EXPECT_EQ(steps_of_sequence(rays).azimuth, 0);
  EXPECT_EQ(steps_of_sequence(rays).elevation, 0);
  EXPECT_EQ(steps_of_sequence({}).azimuth, 0);
}

}  // namespace
}  // namespace ilot
