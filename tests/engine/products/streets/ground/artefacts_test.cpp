// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/artefacts.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "kernels/morphology/flat_zones.h"
#include "tests/oracles/whole_street.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

using test::PixelBox;
using test::put;

test::Artefacts artefacts_of(const Image& range) {
  return test::find_artefacts(test::find_ground(range, {}), {});
}

// All pixels of the boxes stand there, with about their height; at most `others` pixels elsewhere.
void expect_boxes(const Image& got, const std::vector<std::pair<PixelBox, Height>>& boxes, Height slack,
                  std::size_t others = 0) {
  std::vector<Height> want(got.size(), kNoHeight);
  for (const auto& [box, height] : boxes)
    for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
      for (std::uint32_t x = box.x; x < box.x + box.width; ++x) want[std::size_t{y} * got.width + x] = height;
  std::size_t invented = 0;
  for (std::size_t i = 0; i < want.size(); ++i) {
    if (want[i] == kNoHeight) {
      invented += got.values[i] != kNoHeight;
    } else {
      ASSERT_NE(got.values[i], kNoHeight) << i % got.width << " " << i / got.width;
      ASSERT_LE(std::abs(got.values[i] - want[i]), slack) << i % got.width << " " << i / got.width;
    }
  }
  EXPECT_LE(invented, others);
}

TEST(Artefacts, BoxesOnLevelAndSlopingGround) {
  for (const int percent : {0, 2, 8}) {
    Image range = test::sloping_street(400, 140, percent);
    const std::vector<std::pair<PixelBox, Height>> boxes{
        {{60, 60, 80, 36}, 900}, {{200, 40, 10, 10}, 900}, {{260, 80, 8, 8}, 700}, {{300, 30, 30, 20}, 400}};
    for (const auto& [box, height] : boxes) put(range, box, height);
    const test::Artefacts got = artefacts_of(range);
    // A box rises from the highest ground around it, its sloping top with it: up to its length times the slope.
    expect_boxes(got.height, boxes, 25 + 80 * percent / 2);
    for (std::size_t i = 0; i < got.ground.size(); ++i)
      ASSERT_TRUE(got.ground[i] == 0 || got.height.values[i] == kNoHeight);
  }
}

// A car whose far side nobody saw touches the edge of the ground: the ring closes it.
TEST(Artefacts, AtTheEdgeOfTheGround) {
  Image range = test::sloping_street(300, 120, 2);
  const PixelBox car{100, test::kFacade, 60, 30};
  put(range, car, 900);
  expect_boxes(artefacts_of(range).height, {{car, 900}}, 25 + 60);
}

// The pavement ends in a kerb all around: no thing, and what stands on it rises from it.
TEST(Artefacts, APavementIsGround) {
  Image range = test::sloping_street(400, 160, 0);
  put(range, {20, test::kFacade, 360, 50}, 150);
  const PixelBox bin{100, 30, 14, 14}, edge{200, test::kFacade, 20, 20};
  put(range, bin, 800);
  put(range, edge, 800);
  const test::Artefacts got = artefacts_of(range);
  EXPECT_EQ(got.ground[std::size_t{40} * 400 + 50], 1);
  expect_boxes(got.height, {{bin, 800}, {edge, 800}}, 200);
}

TEST(Artefacts, NothingStandsOnEmptyGround) {
  for (const int percent : {0, 5, 20}) {
    const test::Artefacts got = artefacts_of(test::sloping_street(300, 100, percent));
    EXPECT_EQ(flat_zones(got.height, 1 << 20, Adjacency::eight).count, 0u) << percent;
  }
  EXPECT_EQ(artefacts_of({}).height.size(), 0u);
  EXPECT_EQ(artefacts_of(filled_image(4, 4, kNoHeight)).height.values, (std::vector<Height>(16, kNoHeight)));
}

}  // namespace
}  // namespace ilot
