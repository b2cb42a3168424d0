// SPDX-License-Identifier: Apache-2.0
// Inside of find_object_candidates: things beside what they are joined from and with.
#pragma once
#include <span>

#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

// Sets the features from `fill` on of things whose other features are known; parts by their place here, from 1. O(n).
void relate_candidates(std::span<ObjectCandidate> candidates);

}  // namespace ilot
