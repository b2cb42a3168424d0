// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/simple_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ilot {
namespace {

using Ring = std::vector<Point2>;

// However the ring is started and turned.
void expect_simple(Ring ring, bool simple, const char* why) {
  for (int turn = 0; turn < 2; ++turn) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_EQ(is_simple_ring(ring), simple) << why << ", start " << i;
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    }
    std::reverse(ring.begin(), ring.end());
  }
}

TEST(SimpleRing, SeparatesSimpleRingsFromOthers) {
  expect_simple({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true, "a square");
  expect_simple({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, true, "a corner on an edge");
  expect_simple({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, true, "a dent");
  expect_simple({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, false, "a bow tie");
  expect_simple({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, false, "a dent that touches");
  expect_simple({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {-4, 0}, {-4, -4}, {0, -4}}, false, "a corner twice");
  expect_simple({{0, 0}, {4, 0}, {4, 4}, {4, 8}, {4, 4}, {0, 4}}, false, "a spike");
  expect_simple({{0, 0}, {4, 0}, {8, 0}}, false, "a line");
  expect_simple({{0, 0}, {4, 0}, {4, 0}, {4, 4}}, false, "a corner repeated");
  expect_simple({{0, 0}, {4, 0}}, false, "two corners");
  EXPECT_FALSE(is_simple_ring({}));
}

TEST(SimpleRing, APolygonsRingsCrossNowhere) {
  const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_TRUE(is_simple_polygon(std::vector<Ring>{square}));
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{{{0, 0}, {0, 10}, {10, 10}, {10, 0}}})) << "clockwise";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}})) << "bow-tie";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{{{0, 0}, {10, 0}, {10, 10}, {10, 5}, {10, 12}, {0, 10}}}))
      << "back along itself";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{{{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}})) << "touches itself";
  EXPECT_TRUE(is_simple_polygon(std::vector<Ring>{square, {{2, 2}, {2, 4}, {4, 4}}}));
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{square, {{12, 2}, {12, 4}, {14, 4}}})) << "a hole outside";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{square, {{2, 2}, {2, 6}, {6, 6}}, {{3, 4}, {3, 5}, {4, 5}}}))
      << "in a hole";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{square, {{0, 5}, {2, 6}, {2, 4}}})) << "a hole that touches";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{square, {{2, 2}, {4, 2}, {4, 4}}})) << "a hole that turns left";
  EXPECT_FALSE(is_simple_polygon(std::vector<Ring>{{{0, 0}, {1, 1}}}));
  EXPECT_FALSE(is_simple_polygon({}));
}

TEST(SimpleRing, MeasuresAreasAtTheLimit) {
  const std::int32_t m = kMaxPlaneCoordinate;
  EXPECT_TRUE(doubled_area(Ring{{-m, -m}, {m, -m}, {m, m}, {-m, m}}) == static_cast<__int128>(1) << 61);
  EXPECT_TRUE(doubled_area(Ring{{0, 0}, {0, 2}, {2, 0}}) == -4);
  EXPECT_TRUE(is_simple_ring(Ring{{-m, -m}, {m, -m}, {m, m}, {-m, m}}));
}

}  // namespace
}  // namespace ilot
