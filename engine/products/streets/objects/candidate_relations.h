// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: each candidate compared with its parts and with its partner in a join.
#pragma once
#include <span>

#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

// Sets the features from `fill` on. The other features of the candidates are already set. `parts` are positions in this
// list, from 1. O(n).
void relate_candidates(std::span<ObjectCandidate> candidates);

}  // namespace ilot
