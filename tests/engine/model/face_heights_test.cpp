// SPDX-License-Identifier: Apache-2.0
#include "engine/model/face_heights.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/rng.h"
#include "tests/support/buildings.h"

namespace ilot {
namespace {

// A polygon in plan, given by its rings, on the plane z = 2 + gx x + gy y.
Building sloping(const std::vector<std::vector<Vec3>>& rings, double gx, double gy) {
  Building b;
  BuildingSurface surface;
  for (const auto& ring : rings) {
    auto& numbers = surface.rings.emplace_back();
    for (const Vec3& p : ring) {
      numbers.push_back(static_cast<std::uint32_t>(b.vertices.size()));
      b.vertices.push_back({p.x, p.y, 2 + gx * p.x + gy * p.y});
    }
  }
  b.surfaces.push_back(surface);
  return b;
}

TEST(FaceHeights, ARectangleRisesEvenly) {
  const Building house = gable_house("a", {0, 0, 100});
  const FaceHeights south = face_heights(house, house.surfaces[0]);
  EXPECT_EQ(south.min, 103);
  EXPECT_NEAR(south.half, 104.5, 1e-9);
  EXPECT_NEAR(south.seven_tenths, 105.1, 1e-9);
  EXPECT_EQ(south.max, 106);
}

TEST(FaceHeights, ATriangleHasMoreBelow) {
  // The area above a height falls with the square of the distance from the tip.
  const Building hip = sloping({{{0, 0, 0}, {4, 0, 0}, {2, 10, 0}}}, 0, 0.3);
  const FaceHeights h = face_heights(hip, hip.surfaces[0]);
  EXPECT_NEAR(h.half, 2 + 3 * (1 - std::sqrt(0.5)), 1e-9);
  EXPECT_NEAR(h.seven_tenths, 2 + 3 * (1 - std::sqrt(0.3)), 1e-9);
}

TEST(FaceHeights, ALevelFaceHasOneHeight) {
  const Building court = court_house("c");
  const FaceHeights h = face_heights(court, court.surfaces[0]);
  EXPECT_EQ(h.min, 4);
  EXPECT_EQ(h.half, 4);
  EXPECT_EQ(h.seven_tenths, 4);
  EXPECT_EQ(h.max, 4);
}

TEST(FaceHeights, FacesWithoutAreaHaveTheirLowestHeight) {
  EXPECT_EQ(face_heights({}, {}).max, 0);
  const Building line = sloping({{{0, 0, 0}, {4, 0, 0}, {0, 0, 0}}}, 0.5, 0);
  EXPECT_EQ(face_heights(line, line.surfaces[0]).half, 2);
}

// A notched outline with a hole, beside a raster of its points.
TEST(FaceHeights, AgreeWithCountedPoints) {
  const std::vector<std::vector<Vec3>> rings{
      {{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {7, 6, 0}, {7, 3, 0}, {4, 3, 0}, {4, 8, 0}, {0, 8, 0}},
      {{1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 1, 0}}};
  const auto inside = [&](double x, double y) {
    const bool whole = x < 10 && y < 8 && !(x >= 7 && y >= 6) && !(x >= 4 && x < 7 && y >= 3) && !(x >= 7 && y >= 6);
    return whole && !(x >= 1 && x < 3 && y >= 1 && y < 2);
  };
  for (const auto& [gx, gy] : {std::pair(0.4, 0.1), {-0.2, 0.7}, {0.5, 0.0}, {0.0, -1.0}}) {
    const Building b = sloping(rings, gx, gy);
    std::vector<double> z;
    for (double x = 0.005; x < 10; x += 0.01)
      for (double y = 0.005; y < 8; y += 0.01)
        if (inside(x, y)) z.push_back(2 + gx * x + gy * y);
    std::sort(z.begin(), z.end());
    const FaceHeights h = face_heights(b, b.surfaces[0]);
    EXPECT_NEAR(h.half, z[z.size() / 2], 0.01) << gx << " " << gy;
    EXPECT_NEAR(h.seven_tenths, z[z.size() * 7 / 10], 0.01) << gx << " " << gy;
  }
}

}  // namespace
}  // namespace ilot
