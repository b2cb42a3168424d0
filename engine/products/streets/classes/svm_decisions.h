// SPDX-License-Identifier: Apache-2.0
// Inside of the things' machine: what it says of many things at once.
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// Decisions of the machine, thing by thing: one for each pair of classes (0, 1), (0, 2) ... (1, 2) ..., above 0 for the
// first, as libsvm decides but for rounding; and for each class the kernel to the nearest support vector of it. On the
// threads of the calling arena.
struct PairDecisions {
  std::size_t pairs = 0;
  std::vector<double> of;       // pairs for each thing
  std::vector<double> nearest;  // classes for each thing
};
PairDecisions pair_decisions(const ObjectModel& model, std::span<const CandidateFeatures> candidates);

// Shares of all classes, which sum to 1; and the kernels to their nearest support vectors.
struct ClassShares {
  std::vector<double> share, nearest;
};
std::vector<ClassShares> class_shares(const ObjectModel& model, std::span<const CandidateFeatures> candidates);

}  // namespace ilot
