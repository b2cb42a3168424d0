// SPDX-License-Identifier: Apache-2.0
// Means of the points about the cells of a wall. They show steps that single points of a rough wall do not.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/products/facades/openings/trend_surface.h"
#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// Derived: stations lie 5 mm apart (one standard deviation), and materials are measured 2 mm too near or too far: 95 %
// of both together.
inline constexpr double kLeastStep = 0.012;  // metres between the wall and a pane or a plate

// Derived: at the middle between both, a point in six is on the wrong side, and the most of four points of a cell of
// the wall once in 62.
inline constexpr double kStepOfNoise =
    2;  // times the scatter of what is compared: from there on cells of four points do

// Choice: half of the smallest opening, so that the middle of each pane has a mean of its own.
inline constexpr double kWidestMean = 0.15;  // metres over which points are averaged

// Distances from the form of a wall, in metres, positive before it.
struct MeanLimits {
  double from, to;   // what is outside shows nothing
  double low, high;  // what is outside counts as if it were there: single echoes from elsewhere decide nothing
};

struct WallMeans {
  std::vector<float> mean;  // metres before the form, of each cell that has points
  std::vector<std::int32_t> points;
  double step = 0;     // metres: what lies so far before or behind the wall is not taken for the wall
  double scatter = 0;  // metres: standard deviation of means before the form; it contains how the wall bows

  bool has(std::size_t cell) const { return points[cell] > 0; }
};

// Takes the means of the points about each cell that has points, over as few cells as show the least step.
//
// How far a mean scatters is measured on the differences of means that share no point: bowed walls do not change it,
// and edges are few. It contains the roughness of the wall and of its stones, whatever their size. At the middle
// between the wall and something that is one step away, a mean is on the wrong side once in 62. O(points + cells).
WallMeans means_about_cells(const RaySamples& samples, const TrendSurface& form, const WallCells& grid,
                            const MeanLimits& limits);

}  // namespace ilot
