// SPDX-License-Identifier: Apache-2.0
// Internal to the training: the trees that decide the class of an object.
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/classes/role_trees.h"
#include "engine/products/streets/classes/training_sample.h"
#include "training/training_folds.h"

namespace ilot {

// Learns trees that separate the classes of samples. `classes` are their labels, ascending. The trees of all samples
// are surer than they are right on others. So trees of the other folds decide each fold, and the scores of all trees
// are divided by the temperature that makes these decisions the most likely [Guo, Pleiss, Sun and Weinberger 2017].
ColumnTrees learn_class_trees(std::span<const TrainingSample> samples, const std::vector<PointLabel>& classes,
                              const TrainingFolds& folds);

// Trees without the columns that none of them uses.
ColumnTrees only_used(ColumnTrees trees);

}  // namespace ilot
