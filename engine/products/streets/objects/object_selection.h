// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// Which of the things are whole, where parts and what joins them are given (find_object_candidates): a cut through each
// tree of joins, on it what is whole, below it parts, above it several in one. The cut under which the roles of all
// things together are most probable, each by itself; ties: the joined one. For each thing whether it was taken. O(n).
std::vector<std::uint8_t> select_objects(std::span<const ObjectCandidate> candidates,
                                         std::span<const CandidateClass> classes);

// Of each thing that was separated the number of the thing taken that holds it; [0] = 0.
std::vector<std::uint32_t> candidate_of_part(std::span<const ObjectCandidate> candidates,
                                             std::span<const std::uint8_t> taken);

}  // namespace ilot
