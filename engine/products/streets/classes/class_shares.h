// SPDX-License-Identifier: Apache-2.0
// Internal to the classifier of candidates: how probable each class is, by the machine or by the trees of a model.
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// The shares of all classes, which sum to 1, and the similarities to them: of a machine the kernels to their nearest
// support vectors.
struct ClassShares {
  std::vector<double> share, nearest;
};
std::vector<ClassShares> class_shares(const ObjectModel& model, std::span<const CandidateFeatures> candidates);

// The values of some features of all candidates, candidate after candidate.
std::vector<double> feature_rows(std::span<const std::size_t> features, std::span<const CandidateFeatures> candidates);

}  // namespace ilot
