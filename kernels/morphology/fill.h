// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

struct ShortGapsParams {
  std::uint32_t longest = 10;  // pixels without a height, in a row or a column
  Height step = 200;           // units; between the two ends
};

// Gaps between scan lines closed: a pixel without a height in a gap of its row, or of its column, that is no longer
// than `longest` and whose two ends differ by at most `step`, gets the height on the straight line between them, the
// lower one when both rows and columns give one. All other pixels stay. Only the image itself is looked at, not what
// was filled: no order can show. O(n).
Image fill_short_gaps(const Image& image, const ShortGapsParams& params = {});

}  // namespace ilot
