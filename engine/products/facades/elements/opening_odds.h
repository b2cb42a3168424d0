// SPDX-License-Identifier: Apache-2.0
// Whether what was found as an opening is more likely one than not.
#pragma once
#include <cmath>
#include <vector>

#include "engine/model/facade.h"

namespace ilot {

// What is known of an opening when the plan of its facade is complete. Other openings are those of the same facade.
struct OpeningEvidence {
  std::size_t element = 0;                     // its index on the facade
  double width = 0, height = 0;                // metres
  double depth = 0;                            // metres; 0 where nothing was seen in it
  double least_error = 0, greatest_error = 0;  // metres: stated for its edges
  std::size_t in_row = 0;                      // other openings with its foot and its head
  std::size_t alike = 0;                       // other openings of its width and height
  double gap = INFINITY;                       // metres to the nearest other opening
  double off_column = INFINITY;                // metres along the wall between its middle and the nearest other one
  bool beside_unseen = false;                  // it touches a part of the wall that nobody saw
};

// The openings of a facade that were measured, in the order of its elements. O(elements^2).
std::vector<OpeningEvidence> opening_evidence(const Facade& facade, double metres_per_unit);

// The natural logarithm of the odds that a true opening has at least half of its union with this one in common with it:
// logistic regression (Cox 1958) on scenes of the scanner, bench/wild/opening_odds.py. Sizes beyond those that openings
// had there count as the nearest ones.
double opening_log_odds(const OpeningEvidence& evidence);

// Makes openings that are more likely none possible openings, and numbers the elements anew. Returns how many of the
// sides that were not seen went with them. O(elements^2).
std::uint64_t keep_likely_openings(Facade& facade, double metres_per_unit);

}  // namespace ilot
