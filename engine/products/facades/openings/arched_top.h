// SPDX-License-Identifier: Apache-2.0
// Openings with round heads stay round [Marchand 2018, II.5.1].
#pragma once
#include <optional>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// The upper end of an opening. `off` is what a level line is off by: twice the root mean square distance of the slices
// below from the top of the opening, in metres (pointed heads, arcs that were not found); 0 where too few slices show
// it.
struct FoundTop {
  std::optional<TopArc> arc;
  double off = 0;
};

// Finds the arc above an opening whose jambs are known; there is none where the top is straight. The arc is found
// first from the places where rays no longer go through the wall: slice by slice across the opening, and sector by
// sector along the arc. Then it is found from the points on the soffit, where there are enough of them. An arch is
// centred on the middle of its opening. The residuals of its circle are at most `most_misfit` times those of a level
// line. The edge is within twice the residuals of its circle and the noise, and half of the gap between the rays on
// its two sides, of the arc, because arches are no exact circles. O(n log n) in the points around.
FoundTop find_top(const RaySamples& samples, const FoundRectangle& opening, double most_misfit);

// The height of the arch or the point of an opening over its jambs, in metres; 0 without one.
double rise_of(const FoundRectangle& opening);

}  // namespace ilot
