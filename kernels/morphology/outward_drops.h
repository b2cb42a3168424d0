// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Tells whether zones stand above their surroundings. The function counts for each zone of flat_zones (image, lambda,
// eight) the pairs of one of its pixels and a neighbour, across a side or a corner, that is lower by more than lambda.
// It subtracts the pairs whose neighbour is higher by more than lambda. [0] is unused. The result is above 0 for a roof
// or a deck. It is below 0 for ground, from which walls and objects rise. Steps within a zone cancel out. Pixels
// without a height and the end of the image do not count. O(n). Only the result is allocated.
std::vector<std::int32_t> outward_drops(const Image& image, const PixelLabels& zones, Height lambda);

// The step from height a to height b: 1 where a is higher, -1 where b is higher, 0 where they differ by at most lambda
// or one has no height.
inline std::int32_t outward_drop(Height a, Height b, Height lambda) {
  if (a == kNoHeight || b == kNoHeight) return 0;
  const std::int64_t step = std::int64_t{a} - b;
  return static_cast<std::int32_t>(step > lambda) - static_cast<std::int32_t>(step < -std::int64_t{lambda});
}

}  // namespace ilot
