// SPDX-License-Identifier: Apache-2.0
// Inside of the training: how much each role counts in the cut through a tree of joins.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// A thing of a tree of joins: what a machine that has not seen it says of it, and what it may be.
struct RoleSample {
  std::array<double, kCandidateStates> log{};  // of the probability of each state
  std::array<std::uint8_t, kCandidateStates> may{1, 1, 1, 1};
  std::uint32_t parts[2] = {0, 0};  // places in the list, from 1, before its own; 0: it was separated
};

// The weights under which the cuts that are allowed are most probable among all cuts: a cut is as probable as exp of
// the sum over its things of power log p + bias of the state that it gives them (a conditional random field on trees;
// Lafferty, McCallum and Pereira 2001), the weights near 1 and 0 as by a normal deviation of 1. Trees without an
// allowed cut are left out. BFGS with exact gradients, each O(n).
RoleWeights learn_role_weights(std::span<const RoleSample> candidates);

}  // namespace ilot
