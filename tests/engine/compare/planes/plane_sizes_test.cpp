// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/plane_sizes.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TruePlane square(std::uint32_t id, double edge) {
  const Ring3 ring{{100, 0, 0}, {100 + edge, 0, 0}, {100 + edge, edge, 0}, {100, edge, 0}};
  return {id, "roof", {{0, 0, 1}, 0}, {{1, ring, {}}}};
}

TEST(PlaneSizes, CountsByAreaInSpace) {
  TruePlane steep = square(1, 2);  // lifted by its own width: 4 m2 become 5.66
  for (Vec3& v : steep.polygons[0].ring) v.z = v.x;
  EXPECT_NEAR(area_of(steep), 4 * std::sqrt(2.0), 1e-9);
  TruePlane holed = square(2, 4);
  holed.polygons[0].holes.push_back(square(0, 3).polygons[0].ring);
  EXPECT_NEAR(area_of(holed), 7, 1e-9);
  const std::vector<TruePlane> truth{steep, holed, square(3, 1), square(4, 4), {5, "ground", {}, {}}};
  const std::vector<PlaneMatch> matches{{1, 9, 5}, {4, 8, 5}, {5, 7, 5}};
  const PlaneSizes sizes = plane_sizes(matches, truth, {});
  const std::uint64_t expected[4][2]{{1, 1}, {2, 1}, {0, 0}, {1, 0}};
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(sizes[s].truth, expected[s][0]) << s;
    EXPECT_EQ(sizes[s].matched, expected[s][1]) << s;
  }
}

TEST(PlaneSizes, JudgesOnlyWhatIsAskedForAndKnowsFeet) {
  const std::vector<TruePlane> truth{square(1, 6), square(2, 6)};  // 36 square feet are 3.34 m2
  const PlaneSizes sizes = plane_sizes(
      {}, truth, [](std::uint32_t id) { return id == 2; }, 0.3048);
  EXPECT_EQ(sizes[2].truth, 1u);
  EXPECT_EQ(sizes[0].truth + sizes[1].truth + sizes[3].truth, 0u);
}

}  // namespace
}  // namespace ilot
