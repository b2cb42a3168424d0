// SPDX-License-Identifier: Apache-2.0
#include "training/role_training.h"

#include <algorithm>

#include "engine/model/point_label.h"
#include "engine/products/streets/classes/object_model_functions.h"
#include "training/class_training.h"
#include "training/role_weights.h"
#include "training/tree_boosting.h"

namespace ilot {
namespace {

// Choice: from so many samples on, held-out streets lose nothing by sampling, and deeper trees do not overfit. They are
// some hundred streets.
constexpr std::size_t kManySamples = 100'000;
// Choice: one level more than for classes, as there are a hundred times more samples; with many streets two.
constexpr std::size_t kRoleDepth = 5, kDeepRoleDepth = 7;  // of a tree
// Choice: more and smaller steps, at the cost of a third more trees.
constexpr std::size_t kManyRounds = 200;
constexpr double kSmallStep = 0.1;  // factor of what a tree adds
// Choice: as in Ke et al. (2017), a tenth of all rows are drawn from those without a large gradient.
constexpr std::uint32_t kDrawnOf = 8;

TreeBoostingParams boosting_of(std::size_t samples) {
  TreeBoostingParams params;
  params.depth = kRoleDepth;
  if (samples < kManySamples) return params;
  params.depth = kDeepRoleDepth, params.rounds = kManyRounds, params.shrinkage = kSmallStep, params.drawn_of = kDrawnOf;
  return params;
}

CandidateKind nature_of(const TrainingSample& s) {
  if (s.role == CandidateRole::part) return CandidateKind::part;
  if (s.role == CandidateRole::merged) return CandidateKind::merged;
  if (is_street_object(s.label)) return CandidateKind::object;
  return s.label == PointLabel::none ? CandidateKind::nothing : CandidateKind::vegetation;
}

// Samples with the results of the first stage. For the first stage itself there are no results.
struct StageSamples {
  std::vector<CandidateFeatures> features;
  std::vector<CandidateParts> parts;
  std::vector<KindShares> predicted;
};
StageSamples stage_samples(const ChosenSamples& chosen, std::span<const KindShares> predicted) {
  StageSamples out{features_of(chosen.samples), parts_of(chosen.samples), {}};
  if (!predicted.empty())
    for (const std::size_t place : chosen.places) out.predicted.push_back(predicted[place]);
  return out;
}

ColumnTrees train_stage(const ChosenSamples& chosen, std::span<const KindShares> said_of_all,
                        const TreeBoostingParams& params) {
  const StageSamples from = stage_samples(chosen, said_of_all);
  ColumnTrees stage;
  for (std::size_t c = 0; c < (from.predicted.empty() ? kCandidateFeatures : kRoleColumns); ++c)
    stage.columns.push_back(c);
  std::vector<std::uint32_t> kinds;
  for (const TrainingSample& s : chosen.samples) kinds.push_back(static_cast<std::uint32_t>(nature_of(s)));
  const std::vector<CandidateRelations> relations = candidate_relations(from.features, from.parts);
  const auto values = [&](std::size_t column) {
    return role_rows(std::span(stage.columns).subspan(column, 1), {from.features, relations, from.predicted}, 0,
                     from.features.size());
  };
  stage.trees = boost_trees({stage.columns.size(), kCandidateKinds, values, kinds}, params);
  return only_used(std::move(stage));
}

// Returns the result of a stage for each sample, trained on the other folds.
std::vector<KindShares> held_out(std::span<const TrainingSample> all, const TrainingFolds& folds,
                                 std::span<const KindShares> said_of_all, const TreeBoostingParams& params) {
  std::vector<KindShares> out(all.size());
  for (std::uint32_t fold = 0; fold < folds.count(); ++fold) {
    const ChosenSamples others = choose(all, folds, fold, Chosen::of_others);
    const ChosenSamples own = choose(all, folds, fold, Chosen::of_fold);
    if (others.samples.empty()) continue;
    const StageSamples asked = stage_samples(own, said_of_all);
    const auto predicted =
        stage_shares(train_stage(others, said_of_all, params), asked.features, asked.parts, asked.predicted);
    for (std::size_t i = 0; i < predicted.size(); ++i) out[own.places[i]] = predicted[i];
  }
  return out;
}

// Returns the states that a sample may have in a true cut. A candidate that is no object may be split and joined
// freely.
RoleSample role_sample(const TrainingSample& s, const KindShares& shares) {
  RoleSample out;
  const bool object = is_street_object(s.label);
  switch (s.role) {
    case CandidateRole::whole:
      out.may = {object, !object, 1, 1};
      break;
    case CandidateRole::part:
      out.may = {0, 0, 1, 0};
      break;
    case CandidateRole::merged:
      out.may = {0, 0, 0, 1};
      break;
  }
  out.log = state_logs(shares);
  std::copy(s.parts.begin(), s.parts.end(), out.parts);
  return out;
}

RoleWeights weights_of(std::span<const TrainingSample> all, const std::vector<KindShares>& unseen) {
  std::vector<RoleSample> candidates;
  for (std::size_t i = 0; i < all.size(); ++i) candidates.push_back(role_sample(all[i], unseen[i]));
  return learn_role_weights(candidates);
}

}  // namespace

LearntRoles learn_roles(std::span<const TrainingSample> samples, const TrainingFolds& folds, bool with_weights) {
  const TrainingFolds one(samples, 1);
  const ChosenSamples everything = choose(samples, one, 0, Chosen::of_fold);
  const TreeBoostingParams params = boosting_of(samples.size());  // also for the folds
  LearntRoles out;
  out.trees.stages[0] = train_stage(everything, {}, params);
  const std::vector<KindShares> first = held_out(samples, folds, {}, params);
  out.trees.stages[1] = train_stage(everything, first, params);
  if (!with_weights) return out;
  const bool joined =
      std::any_of(samples.begin(), samples.end(), [](const TrainingSample& s) { return s.parts[0] != 0; });
  if (joined && folds.by_group()) out.weights = weights_of(samples, held_out(samples, folds, first, params));
  return out;
}

RoleWeights weights_on(std::span<const TrainingSample> samples, const RoleTrees& trees) {
  return weights_of(samples, kind_shares(trees, features_of(samples), parts_of(samples)));
}

}  // namespace ilot
