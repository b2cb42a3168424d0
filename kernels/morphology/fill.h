// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Hole filling [Hernandez and Marcotegui 2008, 3.2]: raises every minimum that is not joined to the border of the image
// to the height at which water in it would run off over the border. At p: the least, over all paths from p to the
// border, of the highest pixel on the path. Pixels without a height are the lowest of all: those joined to the border
// stay without. Reconstruction by erosion from a marker equal to the image on its border and above all elsewhere
// (Soille 2003); unique, near-linear, costs as reconstruct_by_erosion.
Image fill_holes(const Image& image, Adjacency adjacency);

// Missing pixels filled basin by basin [Hernandez and Marcotegui 2008, 3.2]: every region of pixels without a height,
// joined across sides and corners, gets the lowest height around it, each region for itself, so that far ones do not
// decide. Regions that touch the border of the image are open and stay without. O(n).
Image fill_missing(const Image& image);

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
