// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/gradient.h"

#include <gtest/gtest.h>

#include "tests/support/small_images.h"

namespace ilot {
namespace {

TEST(Gradient, IsTheRangeAroundAPixel) {
  for (const auto& [name, image] : test::small_images()) {
    for (const Adjacency adjacency : test::kAdjacencies) {
      const Image got = gradient(image, adjacency);
      for (std::size_t i = 0; i < image.size(); ++i) {
        Height low = image.values[i], high = image.values[i];
        for (const std::size_t q : test::neighbours_of(image.width, image.height, i, adjacency)) {
          if (image.values[q] == kNoHeight) continue;
          low = std::min(low, image.values[q]);
          high = std::max(high, image.values[q]);
        }
        const Height want = image.values[i] == kNoHeight ? kNoHeight : high - low;
        ASSERT_EQ(got.values[i], want) << name;
      }
    }
  }
}

}  // namespace
}  // namespace ilot
