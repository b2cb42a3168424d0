// SPDX-License-Identifier: Apache-2.0
// City blocks along a street [Hernandez and Marcotegui 2008, 3.1]: the profile of heights along the facades' line, and
// the streets that cut it.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/hough_lines.h"
#include "kernels/rasters/image.h"

namespace ilot {

// Entry i lies i pixels along the line from (x, y), in the direction (dx, dy) of unit length.
struct LineProfile {
  double x = 0, y = 0;
  double dx = 1, dy = 0;
  std::vector<Height> heights = {};
};

// The highest pixel in each step of one pixel along the line, of those within half_width (pixels, inclusive) of it;
// kNoHeight where no pixel has a height. From the first to the last such pixel; dx > 0, or dx = 0 < dy. Empty when the
// line misses the image or nothing near it has a height. O(pixels).
LineProfile profile_along(const Image& image, const ImageLine& line, double half_width);

// Median of each entry and the half_window entries before and after it, fewer at the ends; of an even number the lower
// one. kNoHeight counts as lowest: short gaps close, short spikes go, edges stay. O(n w log w).
std::vector<Height> running_median(const std::vector<Height>& profile, std::uint32_t half_window);

// A valley between two blocks: a street.
struct ProfileCut {
  std::uint32_t at = 0;            // first entry beyond the divide
  std::uint32_t from = 0, to = 0;  // entries of the valley below half its depth, inclusive
  Height floor = kNoHeight;        // lowest entry
  Height depth = 0;                // from the floor to the lower of the two tops beside it; kAboveAll without a floor
};

// Watershed of the profile turned over: tops that rise by more than `depth` (>= 0) above the pass to a higher one are
// blocks, and the profile is cut at the divides between them, in the middle of a level floor (ties: the lower entry).
// kNoHeight is the lowest. From first to last. O(n).
std::vector<ProfileCut> profile_cuts(const std::vector<Height>& profile, Height depth);

}  // namespace ilot
