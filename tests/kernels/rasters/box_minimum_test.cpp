// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/box_minimum.h"

#include <gtest/gtest.h>

#include "tests/support/small_images.h"

namespace ilot {
namespace {

TEST(BoxMinimum, IsTheLowestInTheSquare) {
  for (const auto& [name, image] : test::small_images()) {
    for (const std::uint32_t reach : {0u, 1u, 3u, 100u}) {
      const Image got = box_minimum(image, reach);
      const auto w = std::int64_t{image.width}, h = std::int64_t{image.height}, r = std::int64_t{reach};
      for (std::int64_t y = 0; y < h; ++y)
        for (std::int64_t x = 0; x < w; ++x) {
          Height want = kAboveAll;
          for (std::int64_t v = std::max<std::int64_t>(0, y - r); v <= std::min(h - 1, y + r); ++v)
            for (std::int64_t u = std::max<std::int64_t>(0, x - r); u <= std::min(w - 1, x + r); ++u)
              if (const Height z = image.values[static_cast<std::size_t>(v * w + u)]; z != kNoHeight)
                want = std::min(want, z);
          ASSERT_EQ(got.values[static_cast<std::size_t>(y * w + x)], want == kAboveAll ? kNoHeight : want) << name;
        }
    }
  }
}

}  // namespace
}  // namespace ilot
