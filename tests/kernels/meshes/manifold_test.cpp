// SPDX-License-Identifier: Apache-2.0
#include "kernels/meshes/manifold.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

using Triangles = std::vector<TriangleCorners>;
using Fits = std::vector<TriangleFit>;
constexpr auto kFits = TriangleFit::fits, kReversed = TriangleFit::reversed, kNone = TriangleFit::none;

const Triangles kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(Manifold, TakesAClosedSurface) {
  EXPECT_EQ(fit_triangles(kTetrahedron, 4), (Fits{kFits, kFits, kFits, kFits}));
  EXPECT_TRUE(open_edges(kTetrahedron).empty());
  EXPECT_EQ(count_pieces(kTetrahedron, 4), 1u);
}

TEST(Manifold, FindsAFlippedTriangle) {
  Triangles t = kTetrahedron;
  std::swap(t[2][0], t[2][1]);
  EXPECT_EQ(fit_triangles(t, 4), (Fits{kFits, kFits, kReversed, kFits}));
}

TEST(Manifold, FindsAThirdTriangleAtAnEdge) {
  EXPECT_EQ(fit_triangles(Triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5), (Fits{kFits, kFits, kNone}));
}

TEST(Manifold, FindsASecondUmbrellaAtACorner) {
  Triangles t = kTetrahedron;  // corner 3 is closed
  t.push_back({3, 4, 5});
  EXPECT_EQ(fit_triangles(t, 6).back(), kNone);
  // A fan that would close while another is open at the same corner.
  EXPECT_EQ(fit_triangles(Triangles{{3, 4, 5}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 6),
            (Fits{kFits, kFits, kFits, kNone}));
}

TEST(Manifold, JoinsFansOfOneCorner) {
  const Triangles t{{9, 0, 1}, {9, 2, 3}, {9, 1, 2}, {9, 3, 0}};  // corner 9: two fans, then one, then closed
  EXPECT_EQ(fit_triangles(t, 10), (Fits{kFits, kFits, kFits, kFits}));
}

TEST(Manifold, RefusesDoubleCorners) {
  EXPECT_EQ(fit_triangles(Triangles{{0, 1, 1}}, 2), (Fits{kNone}));
  EXPECT_TRUE(fit_triangles(Triangles{}, 0).empty());
}

TEST(Manifold, FindsBordersAndPieces) {
  const Triangles t{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {6, 7, 8}};
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> border{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5},
                                                                    {5, 6}, {6, 4}, {6, 7}, {7, 8}, {8, 6}};
  EXPECT_EQ(open_edges(t), border);
  EXPECT_EQ(count_pieces(t, 9), 2u) << "a shared corner is enough";
  EXPECT_EQ(count_pieces(Triangles{}, 9), 0u);
}

TEST(Manifold, SeparatesInsideFromOutside) {
  const std::vector<Index3> v{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}};
  EXPECT_EQ(volume_sign(kTetrahedron, v), 1);
  Triangles turned = kTetrahedron;
  for (TriangleCorners& t : turned) std::swap(t[0], t[1]);
  EXPECT_EQ(volume_sign(turned, v), -1);
  EXPECT_EQ(volume_sign(kTetrahedron, std::vector<Index3>{{0, 0, 7}, {5, 0, 7}, {0, 5, 7}, {5, 5, 7}}), 0);
  EXPECT_EQ(volume_sign(Triangles{}, v), 0);
}

}  // namespace
}  // namespace ilot
