// SPDX-License-Identifier: Apache-2.0
// Where a straight edge lies between samples on either side of it.
#pragma once
#include <cstddef>
#include <span>

namespace ilot {

struct EdgeSplit {
  double at = 0;          // middle of the gap between the two sides
  double half_gap = 0;    // the edge lies within this of `at`, as far as the samples tell
  std::size_t wrong = 0;  // samples on the other side than their own
  bool found = false;     // there were samples of both sides
};

// The place that leaves the fewest samples on the wrong side: those of `below` should be smaller, those of `above`
// larger. Of several such gaps the widest (ties: the first). Samples that scan lines put at the edge by turns narrow
// the gap; where every line ends at the same place it is one step wide and says so. O(n log n).
EdgeSplit split_edge(std::span<const double> below, std::span<const double> above);

}  // namespace ilot
