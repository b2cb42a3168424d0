// SPDX-License-Identifier: Apache-2.0
// Heads that meet in a point: pointed arches, and openings below a gable.
#pragma once
#include <optional>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// A pointed head and the place of its crown. The error is that of the head as a whole; the true head is within `off` of
// it everywhere. Metres.
struct FoundPoint {
  PointedTop top;
  double crown = 0, rms = 0, error = 0, off = 0;
  std::uint64_t places = 0;
};

// Finds the point above an opening whose jambs are known, from the places where rays no longer go through the wall:
// slices across flat parts, rows across steep parts, sectors across arcs. Two equal arcs about the middle of the
// opening are compared with two lines. There is no result where their residuals are more than `most_misfit` times those
// of a level head, or more than half of those of the arc that the opening has. `highest` is the place along v up to
// which the cells of the wall are open. O(n log n) in the points around.
std::optional<FoundPoint> find_pointed_top(const RaySamples& samples, const FoundRectangle& opening, double highest,
                                           double most_misfit);

// The place along v at which a pointed head meets a jamb. An arc that is a tangent of the jamb within the error meets
// it at the height of its centre.
double springing_of(const FoundRectangle& opening, Side jamb);

}  // namespace ilot
