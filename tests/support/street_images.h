// SPDX-License-Identifier: Apache-2.0
// Small streets from above, at 20 pixels per metre, in millimetres.
#pragma once
#include "tests/support/small_images.h"

namespace ilot::test {

constexpr std::uint32_t kFacade = 15;  // pixels of facade on each side

// The street runs along x. The ground rises by `percent` and has a roughness of 2 cm. There are facades of 10 m on both
// sides.
inline Image sloping_street(std::uint32_t length, std::uint32_t width, int percent) {
  Image image = filled_image(length, width, 0);
  Rng rng(length, width);
  for (std::uint32_t y = 0; y < width; ++y)
    for (std::uint32_t x = 0; x < length; ++x) {
      const bool facade = y < kFacade || y >= width - kFacade;
      image.values[std::size_t{y} * length + x] =
          static_cast<Height>(x) * percent / 2 + (facade ? 10000 : static_cast<Height>(rng.below(21)));
    }
  return image;
}

struct PixelBox {
  std::uint32_t x, y, width, height;
};

// Raises a box by `by`. kNoHeight removes its heights.
inline void put(Image& image, const PixelBox& box, Height by) {
  for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
    for (std::uint32_t x = box.x; x < box.x + box.width; ++x) {
      Height& v = image.values[std::size_t{y} * image.width + x];
      v = by == kNoHeight ? kNoHeight : v + by;
    }
}

// Returns a street with a roof from side to side. The roof is three times as large as the larger piece of ground beside
// it.
inline Image large_roof() {
  Image image = filled_image(220, 120, 0);
  Rng rng(7);
  for (Height& v : image.values) v = static_cast<Height>(rng.below(21));
  put(image, {45, 0, 135, 120}, 8000);
  put(image, {10, 40, 6, 6}, 3000);
  return image;
}

}  // namespace ilot::test
