// SPDX-License-Identifier: Apache-2.0
// Finds the straight lines that the top of a wall follows: level lines and the lines of gables.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "engine/products/facades/facade_site.h"

namespace ilot {

// Gives the highest place of the rings in each of `count` columns, at u = from + (i + 0.5) cell; it is -infinity where
// no ring passes. With rows, it gives the rightmost place in each row, at v. The rings are multiplied by the sign: -1
// gives the lowest or leftmost place, as its negative. O(corners + crossings).
enum class ProfileOf { columns, rows };
std::vector<double> ring_profile(std::span<const OutlineRing> rings, ProfileOf of, double sign, double from,
                                 double cell, std::size_t count);

struct TopLineParams {
  double tolerance = 0.04;      // metres between the profile and its lines, at most: about two steps
  double least_length = 1;      // metres along a line
  double least_support = 0.75;  // share of its columns that lie on it; what hides the rest hides nothing above it
  double most_above = 0.05;     // share of its columns that may lie above it
  double most_lean_deg = 75;    // a steeper line is a side and no part of a top
};

// A line v = at + slope u, through the columns [first, last] of a profile.
struct TopLine {
  double at = 0, slope = 0;
  std::size_t first = 0, last = 0;

  double height(double u) const { return at + slope * u; }
  bool level() const { return slope == 0; }
};

// Takes, of all lines through two columns, the line that contains the greatest length of the profile. Repeats this with
// the rest of the profile until no line is as long as asked. The result is ordered by place. A line that becomes level
// with a turn within the tolerance is made level, at the median height of its columns. Where the profile is below a
// line, the line is taken to be hidden; where it is above, it contradicts the line. O(lines columns^2) pairs, each
// O(columns): this is for a few hundred columns.
std::vector<TopLine> top_lines(std::span<const double> profile, double cell, const TopLineParams& params = {});

}  // namespace ilot
