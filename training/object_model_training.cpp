// SPDX-License-Identifier: Apache-2.0
#include "training/object_model_training.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/error.h"
#include "engine/model/point_label.h"
#include "engine/products/streets/classes/object_model_functions.h"
#include "kernels/core/parallel.h"
#include "training/class_training.h"
#include "training/feature_selection.h"
#include "training/pair_sigmoid.h"
#include "training/role_training.h"
#include "training/svm_training.h"
#include "training/training_folds.h"

namespace ilot {
namespace {

constexpr int kCosts[] = {0, 3, 6, 9};  // powers of two
constexpr int kGammas[] = {-7, -5, -3, -1};
// Choice: enough for the kinds of a class at several densities; with fewer a rare kind is far from all of them.
constexpr std::uint32_t kMostKept = 60;  // samples of each class in a model of trees
constexpr double kRounding = 1e-3;       // of a kernel, by the few digits of vectors in a model's text

std::vector<PointLabel> classes_of(std::span<const TrainingSample> samples) {
  std::vector<PointLabel> classes;
  for (const TrainingSample& s : samples) classes.push_back(s.label);
  std::sort(classes.begin(), classes.end());
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  return classes;
}

// Takes at most so many samples of each class, evenly spread in their order. The others go to `rest`.
std::vector<TrainingSample> thinned(std::span<const TrainingSample> samples, std::uint32_t most,
                                    std::vector<TrainingSample>& rest) {
  std::map<PointLabel, std::uint64_t> total, seen;
  for (const TrainingSample& s : samples) ++total[s.label];
  std::vector<TrainingSample> kept;
  for (const TrainingSample& s : samples) {
    const std::uint64_t n = total[s.label], i = seen[s.label]++;
    (n <= most || i * most / n != (i + 1) * most / n ? kept : rest).push_back(s);
  }
  return kept;
}

// Returns the samples that a model classifies wrongly.
std::vector<TrainingSample> wrong_ones(const ObjectModel& model, std::span<const TrainingSample> samples) {
  const std::vector<PointLabel> predicted = most_probable_classes(model, features_of(samples));
  std::vector<TrainingSample> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (predicted[i] != samples[i].label) out.push_back(samples[i]);
  return out;
}

void standardise(std::span<const TrainingSample> samples, ObjectModel& model) {
  const auto n = static_cast<double>(samples.size());
  for (const std::size_t f : model.features) {
    double sum = 0, squares = 0;
    for (const TrainingSample& s : samples) sum += signed_root(s.features[f]);
    const double mean = sum / n;
    for (const TrainingSample& s : samples) {
      const double d = signed_root(s.features[f]) - mean;
      squares += d * d;
    }
    model.mean.push_back(mean);
    model.sd.push_back(squares > 0 ? std::sqrt(squares / n) : 1);
  }
}

TrainingSet training_set(std::span<const TrainingSample> samples, const ObjectModel& model,
                         const TrainingFolds& folds) {
  TrainingSet set;
  for (const TrainingSample& s : samples) {
    set.rows.push_back(standardised(model, s.features));
    set.classes.push_back(static_cast<std::uint32_t>(
        std::lower_bound(model.classes.begin(), model.classes.end(), s.label) - model.classes.begin()));
    set.folds.push_back(folds.of(s, set.folds.size()));
  }
  return set;
}

// Mean over the classes of the share that is correct. Rare classes count as much as common ones.
double balanced_hits(const TrainingSet& set, const std::vector<std::vector<double>>& decided, std::size_t classes) {
  std::vector<double> right(classes, 0), all(classes, 0);
  for (std::size_t i = 0; i < set.size(); ++i) {
    ++all[set.classes[i]];
    right[set.classes[i]] += voted(decided[i], classes) == set.classes[i];
  }
  double sum = 0;
  for (std::size_t c = 0; c < classes; ++c) sum += all[c] > 0 ? right[c] / all[c] : 0;
  return sum / static_cast<double>(classes);
}

struct GridBest {
  double cost = 1, gamma = 1, hits = -1;
};

GridBest search_grid(const TrainingSet& set, std::uint32_t folds, std::size_t classes) {
  std::vector<std::vector<double>> hits(std::size(kGammas), std::vector<double>(std::size(kCosts), 0));
  parallel_for(std::size(kGammas), [&](std::size_t g) {
    const KernelTable kernels(set, std::ldexp(1.0, kGammas[g]));
    for (std::size_t c = 0; c < std::size(kCosts); ++c) {
      const auto classifiers = fold_svms(set, kernels, std::ldexp(1.0, kCosts[c]), folds, classes);
      hits[g][c] = balanced_hits(set, held_out(set, kernels, classifiers, classes), classes);
    }
  });
  GridBest best;
  for (std::size_t c = 0; c < std::size(kCosts); ++c)
    for (std::size_t g = 0; g < std::size(kGammas); ++g)
      if (hits[g][c] > best.hits) best = {std::ldexp(1.0, kCosts[c]), std::ldexp(1.0, kGammas[g]), hits[g][c]};
  return best;
}

// Fits the probabilities with the first `even` samples of the set.
void fit_probabilities(const TrainingSet& set, std::size_t even, const std::vector<std::vector<double>>& decided,
                       ObjectModel& model) {
  const std::size_t k = model.classes.size();
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = a + 1; b < k; ++b) {
      std::vector<double> f;
      std::vector<std::uint8_t> first;
      for (std::size_t i = 0; i < even; ++i) {
        if (set.classes[i] != a && set.classes[i] != b) continue;
        f.push_back(decided[i][pair_index(a, b, k)]);
        first.push_back(set.classes[i] == a);
      }
      const Sigmoid s = fit_sigmoid(f, first);
      model.slope.push_back(s.a);
      model.offset.push_back(s.b);
    }
}

void check(std::span<const TrainingSample> samples, std::size_t least_classes) {
  std::map<PointLabel, std::size_t> counts;
  for (const TrainingSample& s : samples) ++counts[s.label];
  if (counts.size() < least_classes)
    throw Error(fmt::format("training needs objects of {} at least", least_classes == 1 ? "a class" : "two classes"),
                ExitCode::usage);
  for (const auto& [label, count] : counts)
    if (count < 2)
      throw Error(
          "training needs two objects of each class at least; there is one of class " + class_name_of(label, {}),
          ExitCode::usage);
}

// Returns for each class the smallest similarity of its even samples, lowered by the rounding. The similarity of a
// sample is the largest kernel with a support vector of its class that is not the sample itself.
std::vector<double> min_similarities(const TrainingSet& set, std::size_t even, const ObjectModel& model) {
  std::vector<double> nearest(even, 0), least(model.classes.size(), 1);
  parallel_for(even, [&](std::size_t i) {
    for (std::size_t v = 0; v < model.vectors.size(); ++v)
      if (model.class_of_vector[v] == set.classes[i] && model.vectors[v] != set.rows[i])
        nearest[i] = std::max(nearest[i], radial(set.rows[i], model.vectors[v], model.gamma));
  });
  for (std::size_t i = 0; i < even; ++i) least[set.classes[i]] = std::min(least[set.classes[i]], nearest[i]);
  for (double& v : least) v *= 1 - kRounding;
  return least;
}

// Trains the support vector machine of the model, for given features, cost and gamma, and fits its probabilities.
void finish(const TrainingSet& set, std::size_t even, std::uint32_t folds, ObjectModel& model) {
  model.vectors.clear(), model.weights.clear(), model.class_of_vector.clear();
  model.slope.clear(), model.offset.clear();
  const std::size_t k = model.classes.size();
  const KernelTable kernels(set, model.gamma);
  fit_probabilities(set, even, held_out(set, kernels, fold_svms(set, kernels, model.cost, folds, k), k), model);
  std::vector<std::size_t> everything(set.size());
  for (std::size_t i = 0; i < everything.size(); ++i) everything[i] = i;
  take_over(train_on(set, kernels, everything, model.cost, k), set, model);
  model.min_similarity = min_similarities(set, even, model);
}

// Trains the support vector machine that separates the classes, and sets how common they are.
void train_svm(std::span<const TrainingSample> all, const TrainingFolds& folds, const ObjectTrainingParams& params,
               ObjectModel& model) {
  std::vector<TrainingSample> rest, ignored;
  std::vector<TrainingSample> samples = thinned(all, params.most_of_class, rest);
  const std::size_t even = samples.size();
  model.classes = classes_of(samples);
  for (const PointLabel label : model.classes) {
    const auto of_class = [label](const TrainingSample& s) { return s.label == label; };
    model.prior.push_back(static_cast<double>(std::count_if(all.begin(), all.end(), of_class)) /
                          static_cast<double>(std::count_if(samples.begin(), samples.end(), of_class)));
  }
  model.min_similarity.assign(model.classes.size(), 0);
  if (model.classes.size() == 1) return;
  model.features = selected_features(samples, params);
  if (model.features.empty()) throw Error("training: no feature separates the classes", ExitCode::usage);
  standardise(samples, model);
  const TrainingSet few = training_set(thinned(samples, params.most_in_grid, ignored), model, folds);
  const GridBest best = search_grid(few, folds.count(), model.classes.size());
  model.cost = best.cost;
  model.gamma = best.gamma;
  finish(training_set(samples, model, folds), even, folds.count(), model);
  const std::vector<TrainingSample> wrong = thinned(wrong_ones(model, rest), params.most_of_class / 3, ignored);
  if (wrong.empty()) return;
  samples.insert(samples.end(), wrong.begin(), wrong.end());
  finish(training_set(samples, model, folds), even, folds.count(), model);
}

// Keeps some samples of each class, by which objects are recognised that are farther from their class than its samples.
void keep_samples(std::span<const TrainingSample> samples, const TrainingFolds& folds, ObjectModel& model) {
  for (std::size_t f = 0; f < kCandidateFeatures; ++f) model.features.push_back(f);
  standardise(samples, model);
  model.gamma = 1 / static_cast<double>(model.features.size());
  std::vector<TrainingSample> rest;
  const TrainingSet kept = training_set(thinned(samples, kMostKept, rest), model, folds);
  model.vectors = kept.rows;
  model.class_of_vector = kept.classes;
  const TrainingSet all = training_set(samples, model, folds);
  model.min_similarity = min_similarities(all, all.size(), model);
}

// Trains the trees that separate the classes. They learn how common the classes are.
void train_class_trees(std::span<const TrainingSample> samples, const TrainingFolds& folds, ObjectModel& model) {
  model.classes = classes_of(samples);
  model.prior.assign(model.classes.size(), 1);
  model.class_trees = learn_class_trees(samples, model.classes, folds);
  keep_samples(samples, folds, model);
}

TrainingFolds folds_of(std::span<const TrainingSample> samples, const ObjectTrainingParams& params) {
  return {samples, std::clamp<std::uint32_t>(static_cast<std::uint32_t>(samples.size()), 2u, params.folds)};
}

bool has_role(const TrainingSample& s) {
  return s.role != CandidateRole::whole;
}

std::vector<TrainingSample> whole_objects(std::span<const TrainingSample> samples) {
  std::vector<TrainingSample> out;
  for (const TrainingSample& s : samples)
    if (!has_role(s) && is_street_object(s.label)) out.push_back(s), out.back().parts = {};
  return out;
}

}  // namespace

std::vector<std::size_t> selected_features(std::span<const TrainingSample> samples,
                                           const ObjectTrainingParams& params) {
  const std::size_t columns = params.features == FeatureSet::document ? kComponentFeatures : kCandidateFeatures;
  const std::vector<PointLabel> classes_seen = classes_of(samples);
  std::vector<double> values;
  std::vector<std::uint32_t> classes;
  for (const TrainingSample& s : samples) {
    for (std::size_t f = 0; f < columns; ++f) values.push_back(s.features[f]);
    classes.push_back(static_cast<std::uint32_t>(std::lower_bound(classes_seen.begin(), classes_seen.end(), s.label) -
                                                 classes_seen.begin()));
  }
  std::vector<std::size_t> chosen;
  for (const SelectedFeature& f : select_features(values, classes, columns, params.max_p)) chosen.push_back(f.feature);
  return chosen;
}

void train_classes(std::span<const TrainingSample> all, const ObjectTrainingParams& params, ObjectModel& model) {
  const std::vector<TrainingSample> objects = model.trees.empty() ? std::vector<TrainingSample>{} : whole_objects(all);
  const std::span<const TrainingSample> chosen = model.trees.empty() ? all : objects;
  check(chosen, model.trees.empty() ? 2 : 1);
  const TrainingFolds folds = folds_of(all, params);
  ObjectModel learnt;
  learnt.recipe = std::move(model.recipe), learnt.trees = std::move(model.trees), learnt.roles = model.roles;
  if (params.classes == ClassMethod::trees && classes_of(chosen).size() > 1)
    train_class_trees(chosen, folds, learnt);
  else
    train_svm(chosen, folds, params, learnt);
  model = std::move(learnt);
}

ObjectModel train_roles(std::span<const TrainingSample> all, const ObjectTrainingParams& params) {
  ObjectModel model;
  LearntRoles learnt = learn_roles(all, folds_of(all, params), params.role_weights);
  model.trees = std::move(learnt.trees);
  model.roles = learnt.weights;
  return model;
}

void learn_weights(std::span<const TrainingSample> samples, ObjectModel& model) {
  model.roles = weights_on(samples, model.trees);
}

ObjectModel train_object_model(std::span<const TrainingSample> all, const ObjectTrainingParams& params) {
  const bool roles = std::any_of(all.begin(), all.end(), has_role);
  if (roles) check(whole_objects(all), 1);
  ObjectModel model = roles ? train_roles(all, params) : ObjectModel{};
  train_classes(all, params, model);
  return model;
}

std::vector<CandidateClass> cross_validate(std::span<const TrainingSample> samples, const ObjectTrainingParams& params,
                                           std::uint32_t folds) {
  const TrainingFolds dealt(samples, folds);
  std::vector<CandidateClass> out(samples.size(), {PointLabel::none, 0, 0});
  for (std::uint32_t fold = 0; fold < folds; ++fold) {
    const ChosenSamples rest = choose(samples, dealt, fold, Chosen::of_others);
    if (rest.samples.size() == samples.size()) continue;
    const ObjectModel model = train_object_model(rest.samples, params);
    const ChosenSamples own = choose(samples, dealt, fold, Chosen::of_fold);
    const std::vector<CandidateClass> classes =
        classify_candidates(model, features_of(own.samples), parts_of(own.samples));
    for (std::size_t i = 0; i < classes.size(); ++i) out[own.places[i]] = classes[i];
  }
  return out;
}

}  // namespace ilot
