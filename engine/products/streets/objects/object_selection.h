// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// Selects the candidates that are whole objects. `candidates` are parts and their joins, as find_object_candidates
// gives them. The selection is a cut through each tree of joins: the candidates on the cut are whole, those below it
// are parts, and those above it are merged. Of all cuts, the one with the greatest probability of the roles of all
// candidates together is taken, with the candidates regarded as independent (ties: the joined candidate). The result
// has one flag per candidate: 1 = taken. O(n).
std::vector<std::uint8_t> select_objects(std::span<const ObjectCandidate> candidates,
                                         std::span<const CandidateClass> classes);

// For each separated part, the number of the taken candidate that contains it; [0] = 0.
std::vector<std::uint32_t> candidate_of_part(std::span<const ObjectCandidate> candidates,
                                             std::span<const std::uint8_t> taken);

}  // namespace ilot
