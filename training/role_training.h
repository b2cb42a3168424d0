// SPDX-License-Identifier: Apache-2.0
// Inside of the training: the trees that say what is whole, and how much the roles count.
#pragma once
#include <span>

#include "engine/products/streets/classes/role_trees.h"
#include "engine/products/streets/classes/training_sample.h"
#include "training/training_folds.h"

namespace ilot {

struct LearntRoles {
  RoleTrees trees;
  RoleWeights weights;
};

// Learns both stages of the trees from samples with roles. What the second learns from, the first says of samples that
// it has not seen: once for each fold it is trained on the others. So are both for the weights (role_weights.h), which
// are learnt only where no fold parts a group and samples are joined from others.
LearntRoles learn_roles(std::span<const TrainingSample> samples, const TrainingFolds& folds);

}  // namespace ilot
