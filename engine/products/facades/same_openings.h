// SPDX-License-Identifier: Apache-2.0
// Openings that are drawn on two sheets of one wall.
#pragma once
#include <span>

#include "engine/products/facades/elements/facade_model.h"

namespace ilot {

// Two facades in nearly one plane show the same hole: a shop front before its wall, a wall of which a second plane was
// found. Of two openings of different facades that face the same way, no farther apart than a wall is thick and with
// more than half of the smaller one in common, the one that is known better stays: that with fewer unseen sides, then
// that with the smaller errors, then that of the earlier facade. A possible opening of which most lies in an opening
// that stays on another sheet goes too. Sills, lintels and leaves of what goes stay on their sheet. A family of which
// one member is left is none. The elements are numbered anew. O(n^2) in the openings.
void drop_same_openings(std::span<FoundFacade> found, double metres_per_unit);

}  // namespace ilot
