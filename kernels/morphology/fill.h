// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

struct ShortGapsParams {
  std::uint32_t longest = 10;  // pixels without a height, in a row or a column
  Height step = 200;           // units; between the two ends
};

// Closes gaps between scan lines. A pixel without a height is filled when it is in a gap of its row or column that is
// no longer than `longest` and whose two ends differ by at most `step`. It gets the height on the straight line between
// the ends, or the lower one when both the row and the column give one. All other pixels stay. Only the given image is
// read and not the filled pixels, so no order of work matters. O(n).
Image fill_short_gaps(const Image& image, const ShortGapsParams& params = {});

}  // namespace ilot
