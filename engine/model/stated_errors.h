// SPDX-License-Identifier: Apache-2.0
// What the edges of a facade state of their errors, in one number.
#pragma once
#include "engine/model/facade.h"

namespace ilot {

// The error in metres within which 95 of 100 seen edges are expected, if that of each is normal and its own stated
// error is the bound of 95 %; 0 where no seen edge states one. Edges that nobody saw, and those that were completed
// from others, may be anywhere in the gap that hid them, and do not count. O(edges).
double seen_error_95(const Facade& facade);

}  // namespace ilot
