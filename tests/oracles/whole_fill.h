// SPDX-License-Identifier: Apache-2.0
// Filling of images that are in memory as a whole. The tiled kernels must give the same result.
#pragma once
#include "kernels/rasters/image.h"

namespace ilot::test {

// Hole filling [Hernandez and Marcotegui 2008, 3.2]: raises every minimum that is not joined to the border of the image
// to the height at which water in it would run off over the border. The value at p is the least, over all paths from p
// to the border, of the highest pixel on the path. Pixels without a height are the lowest of all. Those that are joined
// to the border stay without a height. The method is reconstruction by erosion from a marker that equals the image on
// its border and is above everything elsewhere (Soille 2003). The result is unique. Time is near-linear, the same as
// that of reconstruct_by_erosion.
Image fill_holes(const Image& image, Adjacency adjacency);

// Fills missing pixels basin by basin [Hernandez and Marcotegui 2008, 3.2]. Every region of pixels without a height,
// joined across sides and corners, gets the lowest height around it. Each region is filled by itself, so that distant
// regions have no influence. Regions that touch the border of the image are open and stay without a height. O(n).
Image fill_missing(const Image& image);

}  // namespace ilot::test
