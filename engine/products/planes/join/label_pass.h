// SPDX-License-Identifier: Apache-2.0
// The last word on every point: which plane it lies on, measured against the planes as they are written.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/products/planes/join/join_pass.h"
#include "kernels/geometry/box3.h"

namespace ilot {

constexpr double kSineUnit = 0x1p-30;

// A plane and the points that were labelled with it.
struct PlaneTally {
  Moments moments;               // relative to the plane's anchor
  std::uint64_t content_id = 0;  // a function of the set of points, relative to their tiles
  std::uint64_t sure = 0;  // within half of epsilon, with a normal that leans less than 25 degrees from the plane's
  std::uint64_t with_normal = 0;
  std::uint64_t squared_sines = 0;  // of the angles between their normals and the plane's, in kSineUnit
  std::array<std::uint64_t, kMostColourClasses> colours{};           // points of each colour class
  double low[2]{INFINITY, INFINITY}, high[2]{-INFINITY, -INFINITY};  // along u and v of frame_of(plane, {}), from 0
  IndexBox box{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
};

// Writes "plane" (u32: 0 = none, else 1 + index into the joined planes) of every block, and "tally", what each plane
// got in the block. A point keeps the plane that its cell found for it, as joined, while it lies within epsilon of it
// (cells part the borders of their planes: find_planes). Any other point gets the nearest of the planes that at least
// two of its 12 nearest neighbours within the connectivity have, if it lies within epsilon of one: so planes grow over
// the borders of cells that had too few points to find them. Points that are not wanted get none. Colours are counted
// where there is a palette.
void label_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                const JoinedPlanes& joined, const PassContext& context, const ColourPalette& palette = {});

// Sums of the column "tally" over all blocks: take(index, tally) for each of so many joined planes, ascending. A plane
// without points has an empty tally. Memory: some planes at a time.
void each_tally(const Store& store, std::size_t planes,
                const std::function<void(std::size_t plane, const PlaneTally& tally)>& take);

}  // namespace ilot
