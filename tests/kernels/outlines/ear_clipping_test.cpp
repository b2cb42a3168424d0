// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/ear_clipping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

double ring_area(const std::vector<FlatPoint>& points, const std::vector<std::uint32_t>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const FlatPoint a = points[ring[i]], b = points[ring[(i + 1) % ring.size()]];
    sum += a.x * b.y - b.x * a.y;
  }
  return std::abs(sum) / 2;
}

// All counter-clockwise and as much area as the polygon: then none overlaps another, and they cover it.
void expect_cover(const std::vector<FlatPoint>& points, const Rings& rings) {
  const auto triangles = triangulate(points, rings);
  std::size_t corners = 0;
  double wanted = 0, area = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    corners += rings[r].size() + (r == 0 ? 0 : 2);
    wanted += (r == 0 ? 1 : -1) * ring_area(points, rings[r]);
  }
  EXPECT_EQ(triangles.size(), corners - 2);
  for (const auto& [a, b, c] : triangles) {
    EXPECT_GE(orient2d(points[a], points[b], points[c]), 0);
    area += orient2d(points[a], points[b], points[c]) / 2;
  }
  EXPECT_NEAR(area, wanted, 1e-9 * (1 + wanted));
}

// Appends a star-shaped ring about a centre and returns its corners.
std::vector<std::uint32_t> star(std::vector<FlatPoint>& points, Rng& rng, FlatPoint centre, double least, double most,
                                int corners) {
  std::vector<std::uint32_t> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.28318 * i / corners, radius = least + (most - least) * rng.uniform();
    ring.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

TEST(EarClipping, CutsSquaresAndAnL) {
  const std::vector<FlatPoint> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 4}};
  expect_cover(points, {{0, 1, 2, 3}});
  expect_cover(points, {{3, 2, 1, 0}});
  const std::vector<FlatPoint> l{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  expect_cover(l, {{0, 1, 2, 3, 4, 5}});
}

TEST(EarClipping, LinksHoles) {
  const std::vector<FlatPoint> points{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {3, 1}, {3, 3}, {1, 3},
                                      {5, 1}, {7, 1}, {7, 3}, {5, 3}, {4, 5}, {6, 5}, {6, 8}, {4, 8}};
  expect_cover(points, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  expect_cover(points, {{0, 1, 2, 3}, {7, 6, 5, 4}, {8, 9, 10, 11}, {12, 13, 14, 15}});
}

TEST(EarClipping, CoversRandomStarsWithHoles) {
  Rng rng(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<FlatPoint> points;
    Rings rings;
    rings.push_back(star(points, rng, {0, 0}, 6, 10, 3 + round % 40));
    // A regular triangle of radius 6 keeps 3 around its centre free.
    if (round % 3 > 0) rings.push_back(star(points, rng, {-1.2, 0.3}, 0.3, 0.9, 3 + round % 11));
    if (round % 3 > 1) rings.push_back(star(points, rng, {1.2, 0.2}, 0.3, 0.9, 3 + round % 7));
    expect_cover(points, rings);
  }
}

TEST(EarClipping, TakesWhatIsDegenerate) {
  const std::vector<FlatPoint> points{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}};
  EXPECT_TRUE(triangulate(points, Rings{}).empty());
  EXPECT_TRUE(triangulate(points, Rings{{0, 1}}).empty());
  EXPECT_EQ(triangulate(points, Rings{{0, 1, 2, 3}}).size(), 2u);       // on a line
  EXPECT_EQ(triangulate(points, Rings{{0, 0, 0, 0, 0}}).size(), 3u);    // one corner
  EXPECT_EQ(triangulate(points, Rings{{0, 3, 4}, {1, 2}}).size(), 1u);  // a hole of two corners
  const std::vector<FlatPoint> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  EXPECT_EQ(triangulate(bow, Rings{{0, 1, 2, 3}}).size(), 2u);
}

}  // namespace
}  // namespace ilot
