// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/point_windows.h"

#include <gtest/gtest.h>

#include <set>

#include "kernels/core/rng.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

// Oracle: the window of every point.
std::vector<PointWindow> windows_of_all(const std::vector<Index3>& points, std::int64_t side) {
  std::set<PointWindow> windows;
  for (const Index3 p : points) {
    const auto floor_divided = [&](std::int64_t v) { return (v - ((v % side) + side) % side) / side; };
    windows.insert({floor_divided(p.y), floor_divided(p.x)});
  }
  return {windows.begin(), windows.end()};
}

TEST(PointWindows, AreThoseOfThePoints) {
  Rng rng(5);
  std::vector<Index3> points;
  for (int i = 0; i < 4000; ++i)
    points.push_back(
        {static_cast<std::int64_t>(rng.below(60000)) - 30000, static_cast<std::int64_t>(rng.below(60000)) - 30000, 0});
  for (const std::uint64_t block_points : {100u, 100000u}) {
    const test::CloudStore cloud(points, {.block_points = block_points});
    for (const std::int64_t side : {std::int64_t{1}, std::int64_t{700}, std::int64_t{1} << 30})
      EXPECT_EQ(windows_with_points(cloud.store(), {}, side), windows_of_all(points, side)) << side;
  }
}

// A point far from all others is one window more, however far: nothing is kept for those between.
TEST(PointWindows, AStrayPointIsOneWindow) {
  std::vector<Index3> points;
  for (std::int64_t i = 0; i < 1000; ++i) points.push_back({1000000000 + i, 1000000000 + i % 31, 0});
  const test::CloudStore alone(points);
  const std::size_t windows = windows_with_points(alone.store(), {}, 100).size();
  points.push_back({-2000000000, -2000000000, 0});
  const test::CloudStore cloud(points, {.keep_strays = true});
  EXPECT_EQ(windows_with_points(cloud.store(), {}, 100).size(), windows + 1);
}

}  // namespace
}  // namespace ilot
