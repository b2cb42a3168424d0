// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/packed_image.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Unpacks every kind of rectangle from the words of its rows alone.
void expect_back(const Image& image) {
  const PackedImage packed = packed_image(image);
  for (const std::uint32_t x : {0u, 3u, image.width / 2})
    for (const std::uint32_t y : {0u, image.height / 2}) {
      const TileFrame part{x, y, image.width - x, image.height - y};
      std::vector<Height> out(std::size_t{part.width + 2} * part.height, -7);
      unpack(packed, std::span(packed.words).subspan(packed.rows[y]), part, {out.data(), part.width + 2});
      for (std::uint32_t v = 0; v < part.height; ++v) {
        for (std::uint32_t u = 0; u < part.width; ++u)
          ASSERT_EQ(out[v * (part.width + 2) + u], image.values[std::size_t{y + v} * image.width + x + u]);
        ASSERT_EQ(out[v * (part.width + 2) + part.width], -7);  // nothing beside the rectangle
      }
    }
}

TEST(PackedImage, ComesBack) {
  Rng rng(2, 5);
  for (const Height spread : {1, 3, 60000, 65533, 65534, 65535, 1 << 29})
    for (const std::uint32_t run : {1u, 5u, 9u, 30u, 300u}) {
      Image image = filled_image(101, 13, 0);
      for (std::size_t i = 0; i < image.size();) {
        const auto kind = rng.below(4);
        const Height v = kind == 0 ? kNoHeight : kind == 1 ? kAboveAll : static_cast<Height>(rng.below(spread)) - 500;
        for (std::uint32_t n = rng.below(run) + 1; n > 0 && i < image.size(); --n) image.values[i++] = v;
      }
      expect_back(image);
    }
}

TEST(PackedImage, EndsOfTheTwoByteRange) {
  for (const Height high : {0xfffd, 0xfffe, 0xffff, 0x10000}) {
    Image image = filled_image(9, 1, -3);
    image.values[4] = high - 3;
    image.values[6] = kNoHeight;
    image.values[7] = kAboveAll;
    expect_back(image);
    for (const Height around : {0x7ffd, 0x7ffe, 0x7fff, 0x8000, 0x8001}) {
      image.values[0] = image.values[8] = high;
      image.values[2] = high - around;
      image.values[4] = high + around;
      expect_back(image);
    }
  }
}

TEST(PackedImage, NearHeightsTakeTwoBytesAndRunsNone) {
  Image image = filled_image(512, 4, kNoHeight);
  EXPECT_LT(packed_image(image).words.size(), 16u);
  Rng rng(1);
  for (Height& v : image.values) v = 40000 + static_cast<Height>(rng.below(1000));
  EXPECT_LT(packed_image(image).words.size(), 512u * 4 + 8);
}

}  // namespace
}  // namespace ilot
