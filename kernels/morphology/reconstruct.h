// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Reconstruction by erosion of mask from marker: the marker is eroded but never falls below the mask, until nothing
// changes. The value at p is the least, over all paths from any pixel q to p, of the highest of marker(q) and the mask
// along the path. A marker below the mask is raised to it first. Both images have one size. Empty images give an empty
// image. The result is unique by definition and does not depend on order, ties or tiles. The method combines raster
// scans and a queue (Vincent 1993). The queue is ordered by height, so that no pixel is processed twice. It is O(n) for
// the scans and O(m log(range)) for the m pixels that they leave, for every image. It needs 8 bytes per pixel.
Image reconstruct_by_erosion(const Image& marker, const Image& mask, Adjacency adjacency);

// The dual operation: the marker is dilated but never rises above the mask. A marker above the mask is lowered to it
// first.
Image reconstruct_by_dilation(const Image& marker, const Image& mask, Adjacency adjacency);

}  // namespace ilot
