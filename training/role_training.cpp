// SPDX-License-Identifier: Apache-2.0
#include "training/role_training.h"

#include <algorithm>

#include "engine/products/streets/classes/thing_decisions.h"
#include "training/role_weights.h"
#include "training/tree_boosting.h"

namespace ilot {
namespace {

ThingNature nature_of(const ThingSample& s) {
  if (s.role == ThingRole::part) return ThingNature::part;
  if (s.role == ThingRole::several) return ThingNature::several;
  if (s.label >= PointLabel::car) return ThingNature::object;
  return s.label == PointLabel::none ? ThingNature::nothing : ThingNature::vegetation;
}

// Samples with what the first stage says of them; nothing is said for the first.
struct StageSamples {
  std::vector<ThingFeatures> features;
  std::vector<ThingParts> parts;
  std::vector<NatureShares> said;
};
StageSamples stage_samples(const ChosenSamples& chosen, std::span<const NatureShares> said) {
  StageSamples out{features_of(chosen.samples), parts_of(chosen.samples), {}};
  if (!said.empty())
    for (const std::size_t place : chosen.places) out.said.push_back(said[place]);
  return out;
}

// Columns that no tree asks for go.
RoleStage only_used(RoleStage stage) {
  RoleStage out;
  std::vector<std::uint16_t> place(stage.columns.size(), 0);
  std::vector<std::vector<float>> limits;
  for (std::size_t c = 0; c < stage.columns.size(); ++c) {
    if (stage.trees.limits[c].empty() && c + 1 < stage.columns.size()) continue;  // the last stays: none is no machine
    place[c] = static_cast<std::uint16_t>(out.columns.size());
    out.columns.push_back(stage.columns[c]);
    limits.push_back(stage.trees.limits[c]);
  }
  out.trees = std::move(stage.trees);
  out.trees.limits = std::move(limits);
  for (TreeSplit& s : out.trees.splits) s.column = place[s.column];
  return out;
}

RoleStage train_stage(const ChosenSamples& chosen, std::span<const NatureShares> said_of_all) {
  const StageSamples from = stage_samples(chosen, said_of_all);
  RoleStage stage;
  for (std::size_t c = 0; c < (from.said.empty() ? kThingFeatures : kRoleColumns); ++c) stage.columns.push_back(c);
  std::vector<std::uint32_t> natures;
  for (const ThingSample& s : chosen.samples) natures.push_back(static_cast<std::uint32_t>(nature_of(s)));
  const std::vector<ThingRelations> relations = thing_relations(from.features, from.parts);
  const std::vector<double> rows =
      role_rows(stage.columns, {from.features, relations, from.said}, 0, from.features.size());
  stage.trees = boost_trees({stage.columns.size(), kThingNatures, rows, natures});
  return only_used(std::move(stage));
}

// What a stage says of each sample when trained on the other folds.
std::vector<NatureShares> held_out(std::span<const ThingSample> all, const ThingFolds& folds,
                                   std::span<const NatureShares> said_of_all) {
  std::vector<NatureShares> out(all.size());
  for (std::uint32_t fold = 0; fold < folds.count(); ++fold) {
    const ChosenSamples others = choose(all, folds, fold, Chosen::of_others);
    const ChosenSamples own = choose(all, folds, fold, Chosen::of_fold);
    if (others.samples.empty()) continue;
    const StageSamples asked = stage_samples(own, said_of_all);
    const auto said = stage_shares(train_stage(others, said_of_all), asked.features, asked.parts, asked.said);
    for (std::size_t i = 0; i < said.size(); ++i) out[own.places[i]] = said[i];
  }
  return out;
}

// The states that a sample may have in a true cut. What is no thing may be parted and joined at will.
RoleSample role_sample(const ThingSample& s, const NatureShares& shares) {
  RoleSample out;
  const bool object = s.label >= PointLabel::car;
  switch (s.role) {
    case ThingRole::whole:
      out.may = {object, !object, 1, 1};
      break;
    case ThingRole::part:
      out.may = {0, 0, 1, 0};
      break;
    case ThingRole::several:
      out.may = {0, 0, 0, 1};
      break;
  }
  out.log = state_logs(shares);
  std::copy(s.parts.begin(), s.parts.end(), out.parts);
  return out;
}

RoleWeights weights_of(std::span<const ThingSample> all, const std::vector<NatureShares>& unseen) {
  std::vector<RoleSample> things;
  for (std::size_t i = 0; i < all.size(); ++i) things.push_back(role_sample(all[i], unseen[i]));
  return learn_role_weights(things);
}

}  // namespace

LearntRoles learn_roles(std::span<const ThingSample> samples, const ThingFolds& folds) {
  const ThingFolds one(samples, 1);
  const ChosenSamples everything = choose(samples, one, 0, Chosen::of_fold);
  LearntRoles out;
  out.trees.stages[0] = train_stage(everything, {});
  const std::vector<NatureShares> first = held_out(samples, folds, {});
  out.trees.stages[1] = train_stage(everything, first);
  const bool joined = std::any_of(samples.begin(), samples.end(), [](const ThingSample& s) { return s.parts[0] != 0; });
  if (joined && folds.by_group()) out.weights = weights_of(samples, held_out(samples, folds, first));
  return out;
}

}  // namespace ilot
