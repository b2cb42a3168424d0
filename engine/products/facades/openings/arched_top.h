// SPDX-License-Identifier: Apache-2.0
// Openings with round heads stay round [Marchand 2018, II.5.1].
#pragma once
#include <optional>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// Finds the arc above an opening whose jambs are known; there is no result where the top is straight. The arc is found
// first from the places where rays no longer go through the wall: slice by slice across the opening, and sector by
// sector along the arc. Then it is found from the points on the soffit, where there are enough of them. An arch is
// centred on the middle of its opening. The residuals of its circle are at most `most_misfit` times those of a level
// line. O(n log n) in the points around.
std::optional<TopArc> find_arched_top(const RaySamples& samples, const FoundRectangle& opening, double most_misfit);

}  // namespace ilot
