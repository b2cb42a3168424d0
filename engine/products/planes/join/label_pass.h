// SPDX-License-Identifier: Apache-2.0
// Gives each point its final plane, measured against the planes as they are written.
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

// A plane and the points that have its label.
struct PlaneTally {
  Moments moments;               // relative to the plane's anchor
  std::uint64_t content_id = 0;  // a function of the set of points, relative to their tiles
  std::uint64_t sure = 0;  // points within half of epsilon whose normal is less than 25 degrees from that of the plane
  std::uint64_t with_normal = 0;
  std::uint64_t squared_sines = 0;  // of the angles between normals of points and that of the plane, in kSineUnit
  std::array<std::uint64_t, kMostColourClasses> colours{};           // number of points in each colour class
  double low[2]{INFINITY, INFINITY}, high[2]{-INFINITY, -INFINITY};  // along u and v of frame_of(plane, {}), from 0
  IndexBox box{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};
};

// Writes the column "plane" (u32: 0 = none, else 1 + index into the joined planes) of every block, and "tally", the
// part of each plane in the block. A point keeps the joined plane that extend_pass gives (read_extended) while it is
// within epsilon of it. (The cells have already split the borders of their planes: find_planes.) Any other point looks
// at the planes that at least two of its 12 nearest neighbours within the connectivity have. It gets the nearest of
// these if it is within epsilon of one. In this way planes grow over the borders of cells that had too few points to
// find them. Points that are not wanted get no plane. Colours are counted where there is a palette.
void label_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                const JoinedPlanes& joined, const PassContext& context, const ColourPalette& palette = {});

// Sums the column "tally" over all blocks. Calls take(index, tally) for each of `planes` joined planes, in ascending
// order. A plane without points has an empty tally. The memory is that of some planes at a time.
void each_tally(const Store& store, std::size_t planes,
                const std::function<void(std::size_t plane, const PlaneTally& tally)>& take);

}  // namespace ilot
