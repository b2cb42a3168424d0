// SPDX-License-Identifier: Apache-2.0
// One value from several measurements of the same quantity, each known within bounds.
#pragma once
#include <span>
#include <vector>

namespace ilot {

struct Bounded {
  double value = 0, error = 0;  // the measured quantity is within [value - error, value + error]
};

// Returns the range of values that are in most of the intervals, as its middle and half width. It returns {0, 0} for no
// measurement. Where two ranges tie, the narrower one is taken. More measurements give narrower bounds: when each of n
// edges is known to one scan line, their common width is known to about a scan line over n. The result does not depend
// on the order. O(n log n).
Bounded agreement(std::span<const Bounded> measured);

// Groups measurements that may be equal. In sorted order, a measurement joins the group before it when it differs by no
// more than `tolerance` from the first member of the group. Returns the group of each measurement, numbered from 0 by
// value without gaps. O(n log n).
std::vector<std::size_t> groups_of_equals(std::span<const double> values, double tolerance);

}  // namespace ilot
