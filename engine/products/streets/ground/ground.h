// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/products/streets/ground/raster_scale.h"
#include "kernels/rasters/image.h"

namespace ilot {

struct GroundParams {
  double flat = 1;           // metres; heights of neighbours on the ground differ by at most this
  double longest_gap = 0.5;  // metres; between scan lines
  double gap_step = 0.2;     // metres; between the two sides of such a gap
  double longest_link = 10;  // metres; over a shadow, between regions of the ground
};

struct Ground {
  Image filled;                    // the range image without its gaps, as far as they are closed
  std::vector<std::uint8_t> mask;  // 1: ground, and all that stands on it
};

// A zone so many times smaller than the largest is not the ground.
constexpr std::uint64_t kComparableZones = 10;

// How much speaks for a zone: first that it does not stand above what is around it (zone_falls) and is comparable with
// the largest, then its pixels. A roof may be larger than any piece of ground, but its border falls all around.
using GroundRank = std::pair<bool, std::uint64_t>;
inline GroundRank ground_rank(std::uint64_t pixels, std::int32_t falls, std::uint64_t largest) {
  return {falls <= 0 && pixels * kComparableZones >= largest, pixels};
}

// The ground of a street [Hernandez and Marcotegui 2008, 3.2]: gaps between scan lines closed (ours: the document's
// clouds have a point in every pixel), pixels without a height filled basin by basin; regions that shadows still cut
// apart linked along their shortest connections, and the holes that this closes filled; of the zones flat within `flat`
// the first of those with the greatest ground_rank is the ground (ours: the document takes the largest), and what it
// encloses, as lampposts, belongs to it; what stayed without a height never does. `range`: highest z per pixel. Nothing
// with a height: an empty mask. O(n) but for the links.
Ground find_ground(const Image& range, const RasterScale& scale, const GroundParams& params = {});

}  // namespace ilot
