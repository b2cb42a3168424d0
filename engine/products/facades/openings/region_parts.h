// SPDX-License-Identifier: Apache-2.0
// Openings that a few cells connect past a pier are two.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/products/facades/openings/wall_cells.h"

namespace ilot {

// How wide the wall about a column of a box of cells is, in metres.
using WidthOfWall = std::function<double(const CellBox& box, std::int64_t column)>;

// The width in metres of the wall, and of what lies flat on it, about one column of a box of cells of `cell` metres. On
// both sides of the middle of the column the end is where the rays that were stopped up to there, less those that went
// through the wall and less half as many as the column has on the same width, are the most; then half of the way to the
// next ray, and no more than half of a step. So it is known to a ray where cells show it to a cell only. O(n log n) in
// the rays there.
double pier_width(const RaySamples& samples, double cell, const CellBox& box, std::int64_t column);

// A part of a region; `at_pier`: it was cut off at a pier over whose leaves cells had been joined.
struct RegionPart {
  CellRegion region;
  bool at_pier = false;
};

// Cuts a region between two stretches of at least `least` metres in which it takes half of each column (then of each
// row), where it does not in a strip wider than a bar, and wall, or what lies flat on it, takes half of a column there.
// Arched heads, which become narrower and do not become wide again, are not cut. The parts come in order of their
// place. `cells` are as the rays show them: what lies flat on a pier does not belong to the region although cells were
// joined over it. An upright strip that its cells do not tell from a bar is measured by `width`, where it is given:
// walls between storeys are higher. O(cells of the box).
std::vector<RegionPart> parts_of_region(const WallCells& cells, const CellRegion& region, double least,
                                        const WidthOfWall& width = {});

}  // namespace ilot
