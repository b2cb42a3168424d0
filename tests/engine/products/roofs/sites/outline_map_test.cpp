// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/outline_map.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(OutlineMap, AnOutlineIsSeenFromTheWholeMetreBelowIt) {
  const PlacedOutline o = place_outline({{{-1500, 2999}, {500, 3000}, {500, 7001}}});
  EXPECT_EQ(o.x, -2000);
  EXPECT_EQ(o.y, 2000);
  EXPECT_EQ(o.polygon, (SitePolygon{{{500, 999}, {2500, 1000}, {2500, 5001}}}));
  EXPECT_EQ(o.box.min_x, -1500);
  EXPECT_EQ(o.box.max_y, 7001);
  EXPECT_EQ(seen_from(o, -3000, 0), (SitePolygon{{{1500, 2999}, {3500, 3000}, {3500, 7001}}}));
}

TEST(OutlineMap, FindsWhatBruteForceFinds) {
  Rng rng(11);
  const auto within = [&](std::int64_t reach) {
    return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(2 * reach))) - reach;
  };
  std::vector<PlacedOutline> outlines(1);  // the first has none
  for (int i = 0; i < 400; ++i) {
    const std::int64_t x = within(500000), y = within(500000);
    const std::int64_t w = 1 + (i % 50 == 0 ? 30000000 : 20000), h = 1 + (i % 50 == 0 ? 3000 : 15000);
    outlines.push_back(place_outline({{{x, y}, {x + w, y}, {x + w, y + h}}}));
  }
  std::vector<GridBox> boxes;
  for (const PlacedOutline& o : outlines) boxes.push_back(o.box);
  const OutlineMap map(boxes);
  for (int i = 0; i < 500; ++i) {
    const std::int64_t x = within(700000), y = within(700000);
    const GridBox box{x, y, x + within(40000) + 40000, y + within(40000) + 40000};
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t n = 1; n < outlines.size(); ++n)
      if (outlines[n].box.meets(box)) wanted.push_back(n);
    EXPECT_EQ(map.near(box), wanted);
  }
  EXPECT_TRUE(OutlineMap({}).near({0, 0, 10, 10}).empty());
}

}  // namespace
}  // namespace ilot
