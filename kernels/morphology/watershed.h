// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Marker-driven watershed [Hernandez and Marcotegui 2008, 5.1] (Meyer 1991). The relief is flooded from the markers,
// and every pixel goes to the basin that reaches it first. There are no lines between basins. `markers` has labels from
// 1 where the flood starts and 0 elsewhere. Pixels of the relief without a height are never flooded (0), even when they
// are marked. Ties are decided so that the order of work does not matter. The water rises level by level. Within a
// level it spreads step by step in all basins at once. A pixel that several basins reach in the same step goes to the
// lowest label. The method makes O(n) pushes on a radix heap, one for each pixel, and needs 13 bytes per pixel.
PixelLabels watershed(const Image& relief, const PixelLabels& markers, Adjacency adjacency);

}  // namespace ilot
