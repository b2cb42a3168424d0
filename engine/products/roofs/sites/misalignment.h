// SPDX-License-Identifier: Apache-2.0
// Checks whether outlines lie where the points are. Points are counted for a raster of shifts, summed over outlines.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

constexpr int kShiftReach = 8;  // raster steps to each side
// Choice: half of the step of airborne scans of 4 points a square metre.
constexpr double kShiftStep = 0.25;  // metres
constexpr int kShifts = 2 * kShiftReach + 1;

struct ShiftCounts {
  std::array<std::uint64_t, kShifts * kShifts> inside{};  // points inside the shifted outlines; rows are shifts in y
  std::uint64_t points = 0;
};

struct Misalignment {
  double dx_m = 0, dy_m = 0;            // the move that would align the outlines
  double inside = 0, inside_moved = 0;  // share of the points inside the outlines, before and after this move
};

// Adds the points of buildings that lie within the reach of shifts of the first outline. `outlines` are this outline
// and all near it, from one anchor. The points are in metres from that anchor. About O(points x shifts).
void count_shifts(std::span<const Vec3> points, std::span<const SitePolygon> outlines, ShiftCounts& counts);

void add(ShiftCounts& sum, const ShiftCounts& counts);

// Returns the shift with most points inside (ties: the shortest).
Misalignment misalignment_of(const ShiftCounts& counts);

}  // namespace ilot
