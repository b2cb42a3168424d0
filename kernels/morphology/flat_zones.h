// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Lambda-flat zones [Hernandez and Marcotegui 2008, 3.2] (quasi-flat zones, Meyer 1998): two pixels are in one zone
// when a path of neighbours joins them whose heights differ by at most lambda (>= 0, inclusive) from step to step.
// lambda = 0: flat zones; of an image with one height and kNoHeight: connected components. Pixels without a height are
// in no zone. Zones are numbered by their first pixel, row by row: no order of work can show. Union-find over runs of
// rows, O(n); 8 bytes a pixel.
PixelLabels flat_zones(const Image& image, Height lambda, Adjacency adjacency);

// Pixels of each label; [0] = those without one.
std::vector<std::uint32_t> zone_sizes(const PixelLabels& labels);

// The largest zone, of equal ones the first; 0 when there is none.
std::uint32_t largest_zone(const PixelLabels& labels);

}  // namespace ilot
