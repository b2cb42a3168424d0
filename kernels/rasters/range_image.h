// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/grid.h"
#include "kernels/rasters/image.h"

namespace ilot {

// Range and accumulation images [Hernandez and Marcotegui 2008, 2.2] of a virtual camera above that looks down: per
// pixel the highest z, in scale units from the points' anchor, and the number of points. Usual pixels: 50 mm, and 200
// mm to find city blocks.
struct RangeImage {
  GridFrame frame;
  Image range;                              // kNoHeight where there is no point
  std::vector<std::uint32_t> accumulation;  // 0 there
};

RangeImage empty_range_image(const GridFrame& frame);

// Adds points; those outside the frame are left out. z with magnitude below 2^30; their order cannot show. O(n).
void add_points(RangeImage& image, Points points);

RangeImage range_image(Points points, const GridFrame& frame);

// Adds the part of another image that lies on this one. Frames may differ, but for the pixel, and their corners must
// lie at multiples of it (as frame_of makes them). Order of merging cannot show. O(pixels of `from`).
void merge(RangeImage& into, const RangeImage& from);

// The image of the same points with pixels `factor` (>= 1) times as long, its frame as frame_of would make it: what 5
// pixels a metre have to be for 20. O(pixels).
RangeImage coarser(const RangeImage& image, std::uint32_t factor);

}  // namespace ilot
