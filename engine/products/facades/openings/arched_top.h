// SPDX-License-Identifier: Apache-2.0
// Round-headed openings stay round [Marchand 2018, II.5.1].
#pragma once
#include <optional>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// The arc above an opening whose jambs are known, or nothing where its top is straight. First from where rays cease to
// go through, slice by slice across the opening and sector by sector along the arc, then from the points on the soffit
// where there are enough. An arch stands over the middle of its opening. O(n log n) in the points around.
std::optional<TopArc> find_arched_top(const RaySamples& samples, const FoundRectangle& opening);

}  // namespace ilot
