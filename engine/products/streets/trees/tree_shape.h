// SPDX-License-Identifier: Apache-2.0
// The measures of a tree from the cells of its crown.
#pragma once
#include <cstdint>
#include <span>

#include "kernels/rasters/image.h"

namespace ilot {

// Images of the vegetation in cells, all of the same size. kNoHeight where there is none.
struct VegetationCells {
  Image top, low;  // z of the highest and the lowest point
  Image above;     // height of the highest point above the ground
  Image points;    // number of points
  Image bins;      // bit i: a point in the i-th half metre above the ground; the last bit has all above
};

// Derived: as many bits as a height has whose magnitude is below 2^30.
constexpr std::uint32_t kVegetationBins = 30;
// Choice: shorter than any crown, longer than the step between points on it.
constexpr double kVegetationBin = 0.5;  // metres

struct TreeShape {
  double x = 0, y = 0;      // middle of the cells, in cells from the corner of the images
  std::size_t cells = 0;    // in plan
  double elongation = 1;    // length over width of the ellipse with the same moments
  Height top = kNoHeight;   // z
  Height base = kNoHeight;  // z; a tenth of the cells reach lower
  std::uint64_t points = 0;
};

// Measures the crown of the given cells (at least one). Cells within `trunk` cells of a trunk at (x, y) have no part in
// the base; a negative `trunk` leaves none out.
TreeShape tree_shape(const VegetationCells& cells, std::span<const std::uint32_t> crown, double x, double y,
                     double trunk);

// The share of a crown's sides without a point: eight sides around (x, y), each cut into half metres, from the first to
// the last bin.
double unseen_share(const VegetationCells& cells, std::span<const std::uint32_t> crown, double x, double y,
                    std::uint32_t first_bin, std::uint32_t last_bin);

}  // namespace ilot
