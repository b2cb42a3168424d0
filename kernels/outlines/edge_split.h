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

struct EdgeRange {
  double from = 0, to = 0;
};

// The range that contains the edge in 95 of 100 cases, if it may be anywhere in [from, to] as likely and each sample is
// on its wrong side by chance. How often that happens is learnt from the samples themselves: one more is wrong of two
// more (Laplace's rule of succession). Each place is as likely as the samples that are wrong there; the ends leave out
// one case in forty each. So a gap that is narrow by chance, or that one stray sample made, does not promise too much
// where samples are sparse. Samples outside [from, to] are not used. O(n log n).
EdgeRange edge_range(std::span<const double> below, std::span<const double> above, double from, double to);

}  // namespace ilot
