// SPDX-License-Identifier: Apache-2.0
// Learns a model of things from samples whose class is known. Plain arithmetic: the same on every machine.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/classes/training_sample.h"

namespace ilot {

// Which features may be selected.
enum class FeatureSet : std::uint8_t { document, all };

struct ObjectTrainingParams {
  FeatureSet features = FeatureSet::all;
  double max_p = 0.01;      // of the stepwise selection
  std::uint32_t folds = 5;  // of the cross-validation that the grid is searched by
  std::uint32_t most_in_grid =
      300;  // samples of a class that the grid is searched with; of more, as many evenly spread
  std::uint32_t most_of_class = 900;  // samples of a class that the machine is trained on, likewise
};

// The features that the stepwise selection takes, in its order.
std::vector<std::size_t> selected_features(std::span<const TrainingSample> samples, const ObjectTrainingParams& params);

// Where samples have roles, learns the trees and the weights of roles from all of them (role_training.h), and the
// machine from those that are whole and objects; otherwise the machine from all. For the machine selects features,
// searches cost and gamma on a grid by cross-validation over groups, trains on all with what was best (ties: the lower
// cost, then the lower gamma) and fits the probabilities to the decisions of the cross-validation (Platt 1999 as Lin,
// Lin and Weng 2007 do it). Where samples were left out because a class has many, those that the machine gets wrong (at
// most a third as many) join the others, and it is trained once more; probabilities stay those of the even choice,
// times how many samples each class really had. At least two classes (or roles, and one class) with two samples each,
// else Error(usage).
ObjectModel train_object_model(std::span<const TrainingSample> samples, const ObjectTrainingParams& params = {});

// Cross-validation by groups: what a machine says of each sample when trained on the other folds' samples, all steps of
// the training included.
std::vector<CandidateClass> cross_validate(std::span<const TrainingSample> samples, const ObjectTrainingParams& params,
                                           std::uint32_t folds = 10);

}  // namespace ilot
