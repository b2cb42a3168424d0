// SPDX-License-Identifier: Apache-2.0
// Learns a model of object candidates from samples whose class is known. It uses plain arithmetic, so the model is the
// same on every machine.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/classes/training_sample.h"

namespace ilot {

// The features that may be selected.
enum class FeatureSet : std::uint8_t { document, all };

// What separates the classes: the support vector machine, or boosted trees of all features.
enum class ClassMethod : std::uint8_t { machine, trees };

struct ObjectTrainingParams {
  ClassMethod classes = ClassMethod::machine;
  FeatureSet features = FeatureSet::all;
  double max_p = 0.01;      // of the stepwise selection
  std::uint32_t folds = 5;  // of the cross-validation for the grid search
  std::uint32_t most_in_grid =
      300;  // largest number of samples of a class in the grid search; of more, as many are taken, evenly spread
  bool role_weights = true;  // learn the weights of the roles too, from trees that are trained on the other folds
  std::uint32_t most_of_class = 900;  // largest number of samples of a class to train the classifier with
};

// Returns the features that the stepwise selection takes, in its order.
std::vector<std::size_t> selected_features(std::span<const TrainingSample> samples, const ObjectTrainingParams& params);

// Trains the model. Where samples have roles, it learns the trees and the weights of roles from all samples
// (role_training.h), and the support vector machine from those that are whole and objects. Otherwise it learns the
// support vector machine from all samples. The training of the machine selects features, searches cost and gamma on a
// grid by cross-validation over groups, and trains on all samples with the best values (ties: the lower cost, then the
// lower gamma). It fits the probabilities to the decisions of the cross-validation (Platt 1999 as Lin, Lin and Weng
// 2007 do it). Where samples of a large class were left out, those that the machine classifies wrongly (at most a third
// as many) are added, and it is trained once more. The probabilities stay those of the even choice, multiplied by the
// true number of samples of each class. At least two classes (or roles, and one class) with two samples each are
// needed, otherwise the function throws Error(usage).
ObjectModel train_object_model(std::span<const TrainingSample> samples, const ObjectTrainingParams& params = {});

// Replaces the classes of a model by those that are learnt from the samples that are whole and objects. The roles stay.
void train_classes(std::span<const TrainingSample> samples, const ObjectTrainingParams& params, ObjectModel& model);

// Trains the roles alone, from samples with roles.
ObjectModel train_roles(std::span<const TrainingSample> samples, const ObjectTrainingParams& params = {});

// Replaces the weights of the roles by those that are learnt from samples that the model was not trained with.
void learn_weights(std::span<const TrainingSample> samples, ObjectModel& model);

// Cross-validation by groups. Returns the classification of each sample by a classifier that was trained on the samples
// of the other folds. All steps of the training are included.
std::vector<CandidateClass> cross_validate(std::span<const TrainingSample> samples, const ObjectTrainingParams& params,
                                           std::uint32_t folds = 10);

}  // namespace ilot
