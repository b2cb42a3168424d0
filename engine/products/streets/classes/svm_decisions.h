// SPDX-License-Identifier: Apache-2.0
// Internal to the classifier of candidates: the decisions of the support vector machine for many candidates at once.
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// The decisions of the machine, candidate by candidate. There is one value for each pair of classes (0, 1), (0, 2) ...
// (1, 2) ..., above 0 for the first class, as libsvm decides up to rounding. For each class there is also the kernel to
// its nearest support vector. Runs on the threads of the calling arena.
struct PairDecisions {
  std::size_t pairs = 0;
  std::vector<double> of;       // `pairs` values for each candidate
  std::vector<double> nearest;  // one value per class for each candidate
};
PairDecisions pair_decisions(const ObjectModel& model, std::span<const CandidateFeatures> candidates);

}  // namespace ilot
