// SPDX-License-Identifier: Apache-2.0
// Internal to the training: the weight of each role in the cut through a tree of joins.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// An object candidate in a tree of joins: the result of a classifier that has not seen it, and the states that it may
// have.
struct RoleSample {
  std::array<double, kCandidateStates> log{};  // of the probability of each state
  std::array<std::uint8_t, kCandidateStates> may{1, 1, 1, 1};
  std::uint32_t parts[2] = {0, 0};  // positions in the list, from 1, before its own; 0: the candidate is not a join
};

// Finds the weights under which the allowed cuts are most probable among all cuts. The probability of a cut is
// proportional to exp of the sum of power log p + bias over its object candidates, for the state that the cut gives
// each of them (a conditional random field on trees; Lafferty, McCallum and Pereira 2001). A normal prior with
// deviation 1 keeps the powers near 1 and the biases near 0. Trees without an allowed cut are left out. The method is
// BFGS with exact gradients, each O(n).
RoleWeights learn_role_weights(std::span<const RoleSample> candidates);

}  // namespace ilot
