// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Lambda-flat zones [Hernandez and Marcotegui 2008, 3.2] (quasi-flat zones, Meyer 1998). Two pixels are in one zone
// when they are joined by a path of neighbours whose heights differ by at most lambda (>= 0, inclusive) from step to
// step. With lambda = 0 these are flat zones. In an image of one height and kNoHeight they are connected components.
// Pixels without a height are in no zone. Zones are numbered by their first pixel, row by row, so the order of work
// does not matter. The method is union-find over runs of rows: O(n), 8 bytes per pixel.
PixelLabels flat_zones(const Image& image, Height lambda, Adjacency adjacency);

// Number of pixels of each label. [0] counts the pixels without a label.
std::vector<std::uint32_t> zone_sizes(const PixelLabels& labels);

// Returns the largest zone, the first of equal ones, or 0 when there is none.
std::uint32_t largest_zone(const PixelLabels& labels);

}  // namespace ilot
