// SPDX-License-Identifier: Apache-2.0
// What the rays about a side of an element say of how far its edge may be off.
#pragma once
#include <cstddef>
#include <span>

#include "kernels/outlines/edge_split.h"

namespace ilot {

// Choice: a railing hides less.
inline constexpr double kHiding = 0.2;  // share of the rays beside the end of the wall that met something before it
// Derived: the two-sided 5 % of a test.
inline constexpr double kTailOfEnds = 0.05;  // share of the scan lines that end at one place or another by chance

// The typical distance from a split of the samples within `within` of it that are on its wrong side; 0 where fewer than
// one in twenty are. Wide beams, unsteady angles and stations that do not agree mix the two sides.
double blur_at(std::span<const double> inside, std::span<const double> outside, double split, double within);

// The distance from a split to the farther end of a range.
double farthest_from(const EdgeSplit& split, const EdgeRange& range);

// Without stations nothing shows whether the wall goes on behind what stands before it at the edge of a hole, a
// surround, a sill or a leaf: the edge is at either end of that. Returns half of the distance from `at` to its inner
// end, which is that of the samples `before` in the gap of the split; 0 where these are few beside the `outside`
// samples of the wall.
double half_of_relief(std::span<const double> before, std::size_t outside, const EdgeSplit& split, double at);

}  // namespace ilot
