// SPDX-License-Identifier: Apache-2.0
// What is true of the pavements and the carriageway of `street-wild`. All positions are street coordinates.
#pragma once
#include <vector>

#include "scan/truth_writer.h"
#include "scan/wild/street/wild_street.h"

namespace ilot::scan {

// The pavements along both kerbs, in pieces that end at plots and passages.
std::vector<TruePavement> true_pavements(const WildStreet& street);

// The carriageway, also where the cloud does not keep it, and the roads that meet it, in plan.
std::vector<TrueCarriageway> true_carriageways(const WildStreet& street);

// The convex outline of what an object has below 2.2 m, of the crown of a tree below 1 m, counter-clockwise. Empty
// where all of it is higher.
std::vector<Vec3> low_outline(const WildObject& object);

}  // namespace ilot::scan
