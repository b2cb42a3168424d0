// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Reconstruction by erosion of mask from marker: erosions of the marker that never fall below the mask, until nothing
// changes. At p that is the least, over all paths from any pixel q to p, of the highest of marker(q) and the mask along
// the path. A marker below the mask is raised to it first. Both of one size; empty images give an empty one. Unique by
// definition: no order, tie or tiling can show.
// Hybrid of raster scans and a queue (Vincent 1993), the queue ordered by height so that no pixel is settled twice:
// O(n) for the scans and O(m log(range)) for the m pixels they leave unsettled, whatever the image; 8 bytes a pixel.
Image reconstruct_by_erosion(const Image& marker, const Image& mask, Adjacency adjacency);

// Its dual: dilations of the marker that never rise above the mask. A marker above the mask is lowered to it first.
Image reconstruct_by_dilation(const Image& marker, const Image& mask, Adjacency adjacency);

}  // namespace ilot
