// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Marker-driven watershed [Hernandez and Marcotegui 2008, 5.1] (Meyer 1991): the relief is flooded from the markers,
// every pixel goes to the basin that reaches it first. No lines between basins. `markers`: labels from 1 where the
// flood starts, 0 elsewhere. Pixels of the relief without a height are never flooded (0), marked or not. Ties, so that
// no order of work can show: the water rises level by level; within a level it spreads step by step, all basins at
// once; a pixel that several basins reach in the same step goes to the lowest label. O(n) pushes on a radix heap, each
// pixel once; 13 bytes a pixel.
PixelLabels watershed(const Image& relief, const PixelLabels& markers, Adjacency adjacency);

}  // namespace ilot
