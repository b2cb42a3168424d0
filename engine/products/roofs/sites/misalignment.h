// SPDX-License-Identifier: Apache-2.0
// Do outlines lie where the points say? Counted for a raster of shifts, summed over outlines.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

constexpr int kShiftReach = 8;       // raster steps to each side
constexpr double kShiftStep = 0.25;  // metres
constexpr int kShifts = 2 * kShiftReach + 1;

struct ShiftCounts {
  std::array<std::uint64_t, kShifts * kShifts> inside{};  // points that shifted outlines hold; rows are shifts in y
  std::uint64_t points = 0;
};

struct Misalignment {
  double dx_m = 0, dy_m = 0;            // by which the outlines would have to move
  double inside = 0, inside_moved = 0;  // share of the points that they hold, as they are and moved so
};

// Adds the points of buildings that lie within the reach of shifts of the first outline; outlines: it and all near it,
// from one anchor. Points in metres from that. About O(points x shifts).
void count_shifts(std::span<const Vec3> points, std::span<const SitePolygon> outlines, ShiftCounts& counts);

void add(ShiftCounts& sum, const ShiftCounts& counts);

// The shift that holds most points, of equals the shortest.
Misalignment misalignment_of(const ShiftCounts& counts);

}  // namespace ilot
