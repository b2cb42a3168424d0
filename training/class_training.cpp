// SPDX-License-Identifier: Apache-2.0
#include "training/class_training.h"

#include <algorithm>
#include <cmath>

#include "engine/products/streets/classes/class_shares.h"
#include "kernels/core/portable_math.h"
#include "training/tree_boosting.h"

namespace ilot {
namespace {

// Derived: the likelihood is flat to a hundredth of a temperature.
constexpr int kTemperatureSteps = 40;            // of the search by thirds
constexpr double kCoolest = 0.25, kHottest = 8;  // the temperatures between which is searched

std::uint32_t place_of(const std::vector<PointLabel>& classes, PointLabel label) {
  return static_cast<std::uint32_t>(std::lower_bound(classes.begin(), classes.end(), label) - classes.begin());
}

ColumnTrees trained(std::span<const TrainingSample> samples, const std::vector<PointLabel>& classes) {
  ColumnTrees out;
  for (std::size_t f = 0; f < kCandidateFeatures; ++f) out.columns.push_back(f);
  std::vector<std::uint32_t> of_class;
  for (const TrainingSample& s : samples) of_class.push_back(place_of(classes, s.label));
  const std::vector<CandidateFeatures> features = features_of(samples);
  const auto values = [&](std::size_t column) {
    return feature_rows(std::span(out.columns).subspan(column, 1), features);
  };
  out.trees = boost_trees({out.columns.size(), classes.size(), values, of_class});
  return only_used(std::move(out));
}

// The scores of samples, sample after sample.
std::vector<std::int32_t> scores_of(const ColumnTrees& trees, std::span<const TrainingSample> samples) {
  std::vector<std::int32_t> scores(samples.size() * trees.trees.classes);
  tree_scores(trees.trees, feature_rows(trees.columns, features_of(samples)), scores);
  return scores;
}

// The scores of samples by trees that have not seen their folds, and the class of each.
struct UnseenScores {
  std::size_t classes = 0;
  std::vector<std::int32_t> scores;
  std::vector<std::uint32_t> of_class;
};

UnseenScores unseen_scores(std::span<const TrainingSample> samples, const std::vector<PointLabel>& classes,
                           const TrainingFolds& folds) {
  UnseenScores out;
  out.classes = classes.size();
  for (std::uint32_t fold = 0; fold < folds.count(); ++fold) {
    const ChosenSamples others = choose(samples, folds, fold, Chosen::of_others);
    const ChosenSamples own = choose(samples, folds, fold, Chosen::of_fold);
    if (others.samples.empty() || own.samples.empty()) continue;
    const std::vector<std::int32_t> scores = scores_of(trained(others.samples, classes), own.samples);
    out.scores.insert(out.scores.end(), scores.begin(), scores.end());
    for (const TrainingSample& s : own.samples) out.of_class.push_back(place_of(classes, s.label));
  }
  return out;
}

// The logarithm of the likelihood of the classes where scores are divided by the temperature.
double likelihood(const UnseenScores& unseen, double temperature) {
  const double unit = kTreeUnit / temperature;
  double sum = 0;
  for (std::size_t i = 0; i < unseen.of_class.size(); ++i) {
    const auto row = std::span(unseen.scores).subspan(i * unseen.classes, unseen.classes);
    const std::int32_t most = *std::max_element(row.begin(), row.end());
    double all = 0;
    for (const std::int32_t s : row) all += natural_exp(std::max(-700.0, unit * (s - most)));
    sum += unit * (row[unseen.of_class[i]] - most) - natural_log(all);
  }
  return sum;
}

// The temperature of the greatest likelihood, which has one maximum over the inverse of the temperature.
double best_temperature(const UnseenScores& unseen) {
  double low = 1 / kHottest, high = 1 / kCoolest;
  for (int step = 0; step < kTemperatureSteps; ++step) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (likelihood(unseen, 1 / a) < likelihood(unseen, 1 / b) ? low : high) =
        likelihood(unseen, 1 / a) < likelihood(unseen, 1 / b) ? a : b;
  }
  return 2 / (low + high);
}

}  // namespace

ColumnTrees only_used(ColumnTrees stage) {
  ColumnTrees out;
  std::vector<std::uint16_t> place(stage.columns.size(), 0);
  std::vector<std::vector<float>> limits;
  for (std::size_t c = 0; c < stage.columns.size(); ++c) {
    if (stage.trees.limits[c].empty() && c + 1 < stage.columns.size()) continue;  // an empty list would be invalid
    place[c] = static_cast<std::uint16_t>(out.columns.size());
    out.columns.push_back(stage.columns[c]);
    limits.push_back(stage.trees.limits[c]);
  }
  out.trees = std::move(stage.trees);
  out.trees.limits = std::move(limits);
  for (TreeSplit& s : out.trees.splits) s.column = place[s.column];
  return out;
}

ColumnTrees learn_class_trees(std::span<const TrainingSample> samples, const std::vector<PointLabel>& classes,
                              const TrainingFolds& folds) {
  ColumnTrees out = trained(samples, classes);
  const double temperature = best_temperature(unseen_scores(samples, classes, folds));
  const auto cooled = [&](std::int32_t score) {
    return static_cast<std::int32_t>(std::llround(static_cast<double>(score) / temperature));
  };
  for (auto* list : {&out.trees.first, &out.trees.leaves})
    for (std::int32_t& v : *list) v = cooled(v);
  return out;
}

}  // namespace ilot
