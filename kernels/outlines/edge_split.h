// SPDX-License-Identifier: Apache-2.0
// The place of a straight edge between samples on either side of it.
#pragma once
#include <cstddef>
#include <span>

namespace ilot {

struct EdgeSplit {
  double at = 0;          // middle of the gap between the two sides
  double half_gap = 0;    // the edge is within this of `at`, as far as the samples show
  std::size_t wrong = 0;  // samples on the wrong side
  bool found = false;     // there were samples of both sides
};

// Finds the place that leaves the fewest samples on the wrong side. Samples of `below` should be smaller and samples of
// `above` larger. Of several such gaps the widest is taken (ties: the first). The gap is narrow where scan lines end at
// different places at the edge. Where every line ends at the same place, the gap is one step wide and half_gap shows
// it. O(n log n).
EdgeSplit split_edge(std::span<const double> below, std::span<const double> above);

}  // namespace ilot
