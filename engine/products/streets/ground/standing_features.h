// SPDX-License-Identifier: Apache-2.0
// What stands in cells, and around them, as numbers from which trees learn what it is.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/products/streets/ground/cells.h"
#include "engine/products/streets/ground/standing_form.h"

namespace ilot {

// What the points of a cell give; each is a layer of cells.
enum class CellMeasure : std::uint8_t {
  top,         // units above the terrain
  bins,        // HeightBins of all its points
  deviations,  // three standard deviations of what is high, in steps of the side, smallest first: 10 bits each
  normal,      // |z| of the direction of the smallest, in 1/1000
  upright,     // pixels that are upright
  most_bins,   // most bins from 1 m on of a pixel
  pixels,      // pixels with points
};
constexpr std::size_t kCellMeasures = 7;
using CellMeasures = std::array<Image, kCellMeasures>;
// Choice: 10 bits reach to five sides of a cell; the spread of a higher wall is cut there.
constexpr double kDeviationSteps = 200;  // a side
const char* cell_measure_layer(CellMeasure m);

// The measures of a tile with kStandingHalo cells on all sides, and the number in the tile of one of these cells.
CellMeasures cell_measures_around(const Cells& cells, std::size_t tile);
std::size_t cell_of_tile(const CellMeasures& around, std::uint32_t cell);

// How far around a cell is looked, in cells.
constexpr std::array<std::uint32_t, 3> kStandingReaches{1, 3, 6};
constexpr std::uint32_t kStandingHalo = kStandingReaches.back();

// Number and names of the features, in their order.
std::size_t standing_features();
std::string standing_feature_name(std::size_t feature);

// The features of those cells of a tile whose top is at least `least` units: a row each, in the order of `cells`,
// which are cells of the images with their halo. No feature is a number of points, but sparse clouds change them.
struct StandingRows {
  std::vector<std::uint32_t> cells;
  std::vector<double> rows;
};
StandingRows standing_rows(const CellMeasures& around, const RasterScale& scale, std::uint32_t factor, Height least);

}  // namespace ilot
