// SPDX-License-Identifier: Apache-2.0
// Public functions over points in memory, against brute force and known shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "ilot/clusters.h"
#include "ilot/delaunay.h"
#include "ilot/error.h"
#include "ilot/neighbours.h"
#include "ilot/rasters.h"

namespace ilot {
namespace {

struct PublicPoints {
  std::vector<double> x, y, z;
  void add(double px, double py, double pz) {
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
  }
  PointArrays view() const { return {x, y, z}; }
};

// Whole millimetres at national coordinates, in no order.
PublicPoints scattered(int count) {
  PublicPoints p;
  for (int i = 0; i < count; ++i)
    p.add(652000 + 0.001 * ((i * 7919) % 10007), 6862000 + 0.001 * ((i * 104729) % 9973),
          35 + 0.001 * ((i * 1299709) % 9001));
  return p;
}

TEST(PublicNeighbours, AreThoseOfBruteForce) {
  const PublicPoints p = scattered(700);
  const NeighbourTable table = nearest_neighbours(p.view(), {.count = 7});
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    std::vector<double> all;
    for (std::size_t j = 0; j < p.x.size(); ++j)
      all.push_back(norm({p.x[i] - p.x[j], p.y[i] - p.y[j], p.z[i] - p.z[j]}));
    std::sort(all.begin(), all.end());
    EXPECT_EQ(table.index[7 * i], i);
    for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(table.distance[7 * i + k], all[k], 1e-5) << i << " " << k;
  }
}

TEST(PublicNeighbours, EndAtTheDistanceAndDoNotDependOnThreads) {
  const PublicPoints p = scattered(500);
  const NeighbourTable one = nearest_neighbours(p.view(), {.count = 16, .max_distance = 1, .threads = 1});
  const NeighbourTable two = nearest_neighbours(p.view(), {.count = 16, .max_distance = 1, .threads = 2});
  EXPECT_EQ(one.index, two.index);
  for (std::size_t i = 0; i < one.index.size(); ++i)
    EXPECT_EQ(one.index[i] == kNoPoint, !(one.distance[i] <= 1.0001f)) << i;
  EXPECT_THROW(nearest_neighbours(p.view(), {.count = 65}), Error);
  EXPECT_THROW(nearest_neighbours(p.view(), {.count = 0}), Error);
}

TEST(PublicNormals, OfASlopeAndNoneOfALine) {
  PublicPoints slope, line;
  for (int i = 0; i < 400; ++i) {
    const double x = i % 20, y = i / 20;
    slope.add(x, y, 0.5 * x);
    line.add(i, 0, 0);
  }
  const NormalArrays n = estimate_normals(slope.view());
  const double length = std::sqrt(1.25);
  for (std::size_t i = 0; i < n.x.size(); ++i) {
    EXPECT_NEAR(n.x[i], -0.5 / length, 1e-4);
    EXPECT_NEAR(n.z[i], 1 / length, 1e-4);
    EXPECT_NEAR(n.curvature[i], 0, 1e-4);
  }
  for (const float z : estimate_normals(line.view()).z) EXPECT_EQ(z, 0);
}

TEST(PublicClusters, AreNumberedAsTheyAppear) {
  PublicPoints p;
  for (int i = 0; i < 60; ++i) p.add((i % 3) * 100 + 0.3 * (i / 3), 0, 0);
  const Clusters clusters = euclidean_clusters(p.view(), 0.4);
  EXPECT_EQ(clusters.count, 3u);
  for (std::size_t i = 0; i < clusters.id.size(); ++i) EXPECT_EQ(clusters.id[i], i % 3);
  EXPECT_EQ(euclidean_clusters(p.view(), 0.2).count, 60u);
  EXPECT_THROW(euclidean_clusters(p.view(), 0), Error);
  EXPECT_THROW(euclidean_clusters(p.view(), 1e-5), Error);
}

TEST(PublicDelaunay, OfASquareWithAHole) {
  std::vector<double> x, y;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      if (i > 5 && i < 15 && j > 5 && j < 15) continue;
      x.push_back(652000.5 + i);
      y.push_back(6862000.25 + j);
    }
  const Triangulation t = delaunay(x, y);
  EXPECT_EQ(t.triangles(), 2 * 400 - 2 * 81u);  // Euler: 2 n - 2 - hull
  const AlphaShape shape = alpha_shape(x, y, {.reach = 1});
  ASSERT_EQ(shape.polygons.size(), 1u);
  EXPECT_EQ(shape.polygons[0].size(), 2u);
  EXPECT_NEAR(shape.area, 400 - 100 + 4 * 0.5, 1e-3);  // the corners of the hole are cut
  EXPECT_NEAR(alpha_shape(x, y, {.reach = 1, .fill_holes = true}).area, 400, 1e-3);
  EXPECT_TRUE(alpha_shape(x, y, {.reach = 0.1}).polygons.empty());
  EXPECT_THROW(alpha_shape(x, y, {}), Error);
  EXPECT_THROW(delaunay(x, std::span(y).first(3)), Error);
}

TEST(PublicRasters, OfPointsAndTheirGaps) {
  PublicPoints p;
  for (int i = 0; i < 10; ++i)
    if (i != 4) p.add(100.05 + 0.1 * i, 7.01, i == 0 ? -0.5 : 2);
  p.add(100.06, 7.02, 3);
  const Raster top = raster_of_points(p.view(), 0.1, PixelValue::highest);
  ASSERT_EQ(top.width, 10u);
  ASSERT_EQ(top.height, 1u);
  EXPECT_NEAR(top.x0, 100, 1e-9);
  EXPECT_EQ(top.values[0], 3);
  EXPECT_TRUE(std::isnan(top.values[4]));
  EXPECT_EQ(raster_of_points(p.view(), 0.1, PixelValue::lowest).values[0], -0.5);
  EXPECT_EQ(raster_of_points(p.view(), 0.1, PixelValue::count).values[0], 2);
  EXPECT_EQ(fill_short_gaps(top, 1, 0.1).values[4], 2);
  EXPECT_THROW(fill_short_gaps({0, 0, 1, 3, 3, {}}, 1, 1), Error);
}

TEST(PublicRasters, ReconstructionCutsOffAndWatershedParts) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Raster relief{0, 0, 1, 7, 1, {1, 2, 5, 2.5, 1, none, 1}};
  Raster marker = relief;
  for (std::size_t i = 1; i < 7; ++i) marker.values[i] = -10;
  const Raster low = reconstruct_by_dilation(marker, relief, Adjacency::four);
  EXPECT_EQ(low.values[0], 1);
  EXPECT_EQ(low.values[2], 1);
  EXPECT_TRUE(std::isnan(low.values[5]));
  const std::vector<std::uint32_t> markers{1, 0, 0, 0, 2, 0, 0};
  const auto basins = watershed(relief, markers, Adjacency::four);
  EXPECT_EQ(basins[1], 1u);
  EXPECT_EQ(basins[3], 2u);
  EXPECT_EQ(basins[5], 0u);
}

}  // namespace
}  // namespace ilot
