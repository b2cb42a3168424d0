// SPDX-License-Identifier: Apache-2.0
// The straight lines that the top of a wall follows: level ones, and those of gables.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "engine/products/facades/facade_site.h"

namespace ilot {

// The highest place of the rings in each of `count` columns: at u = from + (i + 0.5) cell; -infinity where none goes
// by. Across: the rightmost place in each row, at v; rings turned by the sign, so that -1 gives the lowest or leftmost
// one (as its negative). O(corners + crossings).
enum class ProfileOf { columns, rows };
std::vector<double> ring_profile(std::span<const OutlineRing> rings, ProfileOf of, double sign, double from,
                                 double cell, std::size_t count);

struct TopLineParams {
  double tolerance = 0.04;      // metres that the profile strays from its lines: about two steps
  double least_length = 1;      // metres along a line
  double least_support = 0.75;  // share of its columns that lie on it; what hides the rest hides nothing above it
  double most_above = 0.05;     // share of its columns that may lie above it
  double most_lean_deg = 75;    // steeper lines are no part of a top but sides
};

// A line v = at + slope u, through the columns [first, last] of a profile.
struct TopLine {
  double at = 0, slope = 0;
  std::size_t first = 0, last = 0;

  double height(double u) const { return at + slope * u; }
  bool level() const { return slope == 0; }
};

// Of all lines through two columns the one that most length of the profile lies on, then of what is left, until nothing
// as long as asked is: by place. A line that a turn within the tolerance makes level is level, at the height of the
// median of its columns. What lies below a line is taken to be hidden there, what lies above it contradicts it.
// O(lines columns^2) pairs, each O(columns): for a few hundred columns.
std::vector<TopLine> top_lines(std::span<const double> profile, double cell, const TopLineParams& params = {});

}  // namespace ilot
