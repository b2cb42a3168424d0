// SPDX-License-Identifier: Apache-2.0
// City blocks along a street [Hernandez and Marcotegui 2008, 3.1]: the profile of heights along the line of the
// facades, and the streets that cut it.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/hough_lines.h"
#include "kernels/rasters/image.h"

namespace ilot {

// Entry i is i pixels along the line from (x, y), in the direction (dx, dy) of unit length.
struct LineProfile {
  double x = 0, y = 0;
  double dx = 1, dy = 0;
  std::vector<Height> heights = {};
};

// Returns for each step of one pixel along the line the highest pixel within half_width (pixels, inclusive) of the
// line, or kNoHeight where no pixel has a height. The profile goes from the first to the last pixel with a height, with
// dx > 0, or dx = 0 < dy. It is empty when the line misses the image or when no pixel near it has a height. O(pixels).
LineProfile profile_along(const Image& image, const ImageLine& line, double half_width);

// Returns for each entry the median of it and of the half_window entries before and after it, or fewer at the ends. Of
// an even number of entries the lower median is taken. kNoHeight counts as the lowest height. So short gaps close,
// short spikes disappear and edges stay. O(n w log w).
std::vector<Height> running_median(const std::vector<Height>& profile, std::uint32_t half_window);

// A valley between two blocks, which is a street.
struct ProfileCut {
  std::uint32_t at = 0;            // first entry beyond the divide
  std::uint32_t from = 0, to = 0;  // entries of the valley below half its depth, inclusive
  Height floor = kNoHeight;        // lowest height
  Height depth = 0;                // from the floor to the lower of the two tops beside it; kAboveAll without a floor
};

// Finds the watersheds of the inverted profile. Tops that rise by more than `depth` (>= 0) above the pass to a higher
// one are blocks. The profile is cut at the divides between them, in the middle of a level floor (ties: the lower
// entry). kNoHeight is the lowest. The cuts are in order from first to last. O(n).
std::vector<ProfileCut> profile_cuts(const std::vector<Height>& profile, Height depth);

}  // namespace ilot
