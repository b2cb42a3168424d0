// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/image.h"

namespace ilot {

struct GroundParams {
  double flat = 1;           // metres; heights of neighbours on the ground differ by at most this
  double longest_gap = 0.5;  // metres; longest gap between scan lines that is closed
  double gap_step = 0.2;     // metres; greatest height difference between the two sides of such a gap
  double longest_link = 10;  // metres; longest link over a shadow between regions of the ground
};

// A zone that is more than this many times smaller than the largest one is not the ground.
constexpr std::uint64_t kComparableZones = 10;

// The rank of a zone as ground. The first value is whether the zone does not stand above its surroundings
// (outward_drops) and is comparable in size with the largest zone. The second value is the number of its pixels. A roof
// can be larger than any piece of ground, but its border drops on all sides.
using GroundRank = std::pair<bool, std::uint64_t>;
inline GroundRank ground_rank(std::uint64_t pixels, std::int32_t drops, std::uint64_t largest) {
  return {drops <= 0 && pixels * kComparableZones >= largest, pixels};
}

}  // namespace ilot
