// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// Choice: longer than a tram's car; what is longer is a wall, a fence or a hedge.
constexpr double kLongestObject = 20;  // metres

// Whether a candidate has the form of a wall, a fence or a hedge: a strip that stands on the ground over its length.
// Wires and branches do not stand on it, and a row of parked cars is wider. `pixel` is the side of a pixel in metres:
// an extent may be one too great at each end.
bool is_strip_on_ground(const ObjectCandidate& candidate, double pixel);

// Objects that are too long and have the form of a fence become one, with the probability that is stated for their
// class.
void name_long_strips(std::span<const ObjectCandidate> candidates, double pixel, std::vector<CandidateClass>& classes);

}  // namespace ilot
