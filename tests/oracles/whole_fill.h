// SPDX-License-Identifier: Apache-2.0
// Filling of images that are in memory as a whole: what the tiled kernels must agree with.
#pragma once
#include "kernels/rasters/image.h"

namespace ilot::test {

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

}  // namespace ilot::test
