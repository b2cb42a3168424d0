// SPDX-License-Identifier: Apache-2.0
// One value for several measurements of the same thing, each known within bounds.
#pragma once
#include <span>
#include <vector>

namespace ilot {

struct Bounded {
  double value = 0, error = 0;  // what is measured lies within [value - error, value + error]
};

// The values that lie in most of the intervals, as their middle and half width: {0, 0} of none. Where two stretches
// tie, the narrower. Bounds narrow down: of n edges whose places are known to a scan line each, the common width is
// known to about a line over n. O(n log n), in any order the same.
Bounded agreement(std::span<const Bounded> measured);

// Groups of what may be the same: sorted by value, a measurement joins the group before it while they differ by no more
// than `tolerance` from the group's first member. Per measurement its group, dense from 0 by value. O(n log n).
std::vector<std::size_t> groups_of_equals(std::span<const double> values, double tolerance);

}  // namespace ilot
