// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/separation.h"

#include <gtest/gtest.h>

#include "tests/support/street_images.h"

namespace ilot {
namespace {

Image nothing() {
  return filled_image(120, 80, kNoHeight);
}

void add_box(Image& image, const test::PixelBox& box, Height height) {
  for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
    for (std::uint32_t x = box.x; x < box.x + box.width; ++x)
      image.values[std::size_t{y} * image.width + x] = height + static_cast<Height>((x + y) % 3) * 20;
}

std::uint32_t label_at(const PixelLabels& labels, std::uint32_t x, std::uint32_t y) {
  return labels.of[std::size_t{y} * labels.width + x];
}

TEST(Separation, ObjectsApartAndObjectsThatTouch) {
  Image height = nothing();
  add_box(height, {5, 5, 40, 20}, 1500);    // a car
  add_box(height, {45, 10, 10, 10}, 1750);  // somebody at its end: higher, no pass between
  add_box(height, {70, 40, 12, 12}, 1700);
  add_box(height, {82, 43, 6, 4}, 900);  // what joins the two is lower
  add_box(height, {88, 40, 12, 12}, 1700);
  const PixelLabels got = separate_artefacts(height, {});
  EXPECT_NE(label_at(got, 75, 45), label_at(got, 95, 45));
  EXPECT_NE(label_at(got, 75, 45), label_at(got, 20, 15));
  for (std::size_t i = 0; i < got.of.size(); ++i) EXPECT_EQ(got.of[i] != 0, height.values[i] != kNoHeight);
}

TEST(Separation, RoughTopsStayOne) {
  Image height = nothing();
  add_box(height, {20, 20, 60, 30}, 1400);  // 40 mm of roughness, below the rise
  EXPECT_EQ(separate_artefacts(height, {}).count, 1u);
}

TEST(Separation, SpecksAreDropped) {
  Image height = nothing();
  add_box(height, {20, 20, 3, 3}, 1400);  // 9 pixels, 10 are asked for
  add_box(height, {60, 20, 4, 3}, 1400);
  const PixelLabels got = separate_artefacts(height, {});
  EXPECT_EQ(got.count, 1u);
  EXPECT_EQ(label_at(got, 21, 21), 0u);
  EXPECT_EQ(label_at(got, 61, 21), 1u);
  EXPECT_EQ(separate_artefacts({}, {}).count, 0u);
  EXPECT_EQ(separate_artefacts(nothing(), {}).count, 0u);
}

TEST(Separation, SmallArtefactsAreWhole) {
  Image height = nothing();
  add_box(height, {20, 20, 12, 10}, 1400);
  height.values[std::size_t{25} * height.width + 25] = 1900;  // a small peak is no top of its own
  add_box(height, {60, 20, 2, 1}, 1000);                      // a bollard
  height.values[std::size_t{20} * height.width + 61] = 300;   // its rim
  add_box(height, {80, 20, 1, 1}, 1000);
  SeparationParams params;
  params.least_area = 0.005;  // two pixels
  const PixelLabels got = separate_artefacts(height, {}, params);
  EXPECT_EQ(got.count, 2u);
  EXPECT_EQ(label_at(got, 25, 25), label_at(got, 20, 20));
  EXPECT_NE(label_at(got, 60, 20), 0u);
  EXPECT_EQ(label_at(got, 60, 20), label_at(got, 61, 20));
  EXPECT_NE(label_at(got, 60, 20), label_at(got, 20, 20));
  EXPECT_EQ(label_at(got, 80, 20), 0u);
}

}  // namespace
}  // namespace ilot
