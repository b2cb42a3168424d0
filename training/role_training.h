// SPDX-License-Identifier: Apache-2.0
// Internal to the training: the trees that decide what is whole, and the weights of the roles.
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

// Learns both stages of the trees from samples with roles. The second stage learns from the results of the first stage
// for samples that the first stage has not seen: for each fold the first stage is trained on the other folds. For the
// weights (role_weights.h) both stages are trained in the same way, which is nearly half of all the work. The weights
// are learnt only if they are asked for, where no fold splits a group and where samples are joins of others.
LearntRoles learn_roles(std::span<const TrainingSample> samples, const TrainingFolds& folds, bool with_weights);

// Learns the weights from samples that the trees were not trained with.
RoleWeights weights_on(std::span<const TrainingSample> samples, const RoleTrees& trees);

}  // namespace ilot
