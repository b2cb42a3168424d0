// SPDX-License-Identifier: Apache-2.0
#include "kernels/meshes/self_intersection.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Triangles = std::vector<TriangleCorners>;
using Found = std::vector<std::uint32_t>;

TEST(SelfIntersection, LetsNeighboursBe) {
  const std::vector<Index3> v{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}};
  EXPECT_TRUE(meeting_triangles(Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, v).empty());
  EXPECT_TRUE(meeting_triangles(Triangles{}, v).empty());
}

TEST(SelfIntersection, FindsFoldsAlongAnEdge) {
  const std::vector<Index3> v{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {2, 2, 0}, {2, -2, 0}, {2, 2, 1}};
  EXPECT_EQ(meeting_triangles(Triangles{{0, 1, 2}, {1, 0, 3}}, v), (Found{0, 1})) << "one over the other";
  EXPECT_TRUE(meeting_triangles(Triangles{{0, 1, 2}, {1, 0, 4}}, v).empty()) << "side by side";
  EXPECT_TRUE(meeting_triangles(Triangles{{0, 1, 2}, {1, 0, 5}}, v).empty()) << "at an angle";
  EXPECT_EQ(meeting_triangles(Triangles{{0, 1, 2}, {2, 1, 0}}, v), (Found{0, 1})) << "the same one twice";
}

TEST(SelfIntersection, FindsCrossingsAtACornerAndElsewhere) {
  const std::vector<Index3> v{{0, 0, 0},   {6, 0, 0},    {0, 6, 0},  {2, 2, -1}, {2, 2, 1},
                              {-2, -2, 1}, {-2, -2, -1}, {1, 1, -1}, {1, 1, 1},  {9, 9, 0}};
  EXPECT_EQ(meeting_triangles(Triangles{{0, 1, 2}, {0, 3, 4}}, v), (Found{0, 1})) << "through from their corner";
  EXPECT_TRUE(meeting_triangles(Triangles{{0, 1, 2}, {0, 5, 6}}, v).empty()) << "away from their corner";
  EXPECT_EQ(meeting_triangles(Triangles{{0, 5, 6}, {0, 1, 2}, {7, 8, 9}}, v), (Found{1, 2}));
}

TEST(SelfIntersection, LeavesOutTrianglesWithoutArea) {
  const std::vector<Index3> v{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {1, 1, -1}, {1, 1, 1}, {1, 1, 3}};
  EXPECT_TRUE(meeting_triangles(Triangles{{0, 1, 2}, {3, 4, 5}}, v).empty());
}

TEST(SelfIntersection, SweepFindsWhatAllPairsFind) {
  Rng rng(3);
  std::size_t found = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<Index3> v;
    Triangles triangles;
    for (std::uint32_t i = 0; i < 40; ++i) {
      const Index3 at{static_cast<std::int64_t>(rng.below(100)), static_cast<std::int64_t>(rng.below(100)),
                      static_cast<std::int64_t>(rng.below(100))};
      for (int k = 0; k < 3; ++k)
        v.push_back({at.x + static_cast<std::int64_t>(rng.below(30)), at.y + static_cast<std::int64_t>(rng.below(30)),
                     at.z + static_cast<std::int64_t>(rng.below(30))});
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    std::vector<bool> meets(triangles.size());
    for (std::size_t a = 0; a < triangles.size(); ++a) {
      for (std::size_t b = a + 1; b < triangles.size(); ++b) {
        const IndexTriangle s{v[3 * a], v[3 * a + 1], v[3 * a + 2]}, t{v[3 * b], v[3 * b + 1], v[3 * b + 2]};
        if (widest_axis(s) >= 0 && widest_axis(t) >= 0 && triangles_meet(s, t)) meets[a] = meets[b] = true;
      }
    }
    Found wanted;
    for (std::uint32_t i = 0; i < meets.size(); ++i)
      if (meets[i]) wanted.push_back(i);
    found += wanted.size();
    EXPECT_EQ(meeting_triangles(triangles, v), wanted);
  }
  EXPECT_GT(found, 20u);
}

}  // namespace
}  // namespace ilot
