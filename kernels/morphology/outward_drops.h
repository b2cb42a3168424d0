// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Whether zones stand above what is around them. Of each zone of flat_zones (image, lambda, eight), [0] unused: pairs
// of one of its pixels and a neighbour, of sides and corners, that is lower by more than lambda, less those where it is
// higher. Above 0 around a roof or a deck; below 0 around ground, from which walls and things rise. Steps within a zone
// cancel out, and pixels without a height and the end of the image count for nothing. O(n), no allocation but the
// result.
std::vector<std::int32_t> outward_drops(const Image& image, const PixelLabels& zones, Height lambda);

// One step from height a to height b: 1 where a stands above, -1 where b does, 0 between what differs by at most lambda
// or has no height.
inline std::int32_t outward_drop(Height a, Height b, Height lambda) {
  if (a == kNoHeight || b == kNoHeight) return 0;
  const std::int64_t step = std::int64_t{a} - b;
  return static_cast<std::int32_t>(step > lambda) - static_cast<std::int32_t>(step < -std::int64_t{lambda});
}

}  // namespace ilot
