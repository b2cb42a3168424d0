// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/role_trees.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::size_t kTreesGrain = 512;  // candidates
// Derived: keeps logarithms finite; below one sample in those that models are trained on.
constexpr double kLeastTreeShare = 1e-6;  // lower bound of a probability
// Derived: below every logarithm of a share of 1e-6.
constexpr double kNoRelation = -1e6;  // value for a missing relative; below all logarithms of shares
constexpr const char* kKindNames[] = {"nothing", "vegetation", "part", "merged", "object"};
constexpr const char* kRelations[] = {"itself", "joined", "beside", "larger part", "lesser part"};

double area_of(const CandidateFeatures& f) {
  return f[static_cast<std::size_t>(ComponentFeature::area)];
}

}  // namespace

std::string role_column_name(std::size_t column) {
  if (column < kCandidateFeatures) return candidate_feature_name(column);
  const std::size_t asked = column - kCandidateFeatures;
  return std::string(kRelations[asked / kCandidateKinds]) + ": " + kKindNames[asked % kCandidateKinds];
}

std::vector<CandidateRelations> candidate_relations(std::span<const CandidateFeatures> candidates,
                                                    std::span<const CandidateParts> parts) {
  assert(parts.size() == candidates.size());
  std::vector<CandidateRelations> out(candidates.size());
  const auto set = [&](std::uint32_t candidate, CandidateRelation relation, std::uint32_t to) {
    out[candidate - 1][static_cast<std::size_t>(relation)] = to;
  };
  for (std::uint32_t i = 1; i <= candidates.size(); ++i) {
    set(i, CandidateRelation::itself, i);
    const auto [a, b] = parts[i - 1];
    if (a == 0) continue;
    const bool first = area_of(candidates[a - 1]) >= area_of(candidates[b - 1]);
    set(i, CandidateRelation::larger_part, first ? a : b);
    set(i, CandidateRelation::lesser_part, first ? b : a);
    set(a, CandidateRelation::beside, b), set(b, CandidateRelation::beside, a);
    for (const std::uint32_t part : {a, b}) set(part, CandidateRelation::joined, i);
  }
  return out;
}

std::vector<double> role_rows(std::span<const std::size_t> columns, const RoleInputs& about, std::size_t first,
                              std::size_t count) {
  std::vector<double> rows;
  rows.reserve(columns.size() * count);
  for (std::size_t i = first; i < first + count; ++i)
    for (const std::size_t c : columns) {
      if (c < kCandidateFeatures) {
        rows.push_back(about.candidates[i][c]);
        continue;
      }
      const std::size_t asked = c - kCandidateFeatures;
      const std::uint32_t whom = about.relations[i][asked / kCandidateKinds];
      rows.push_back(whom == 0
                         ? kNoRelation
                         : natural_log(std::max(kLeastTreeShare, about.predicted[whom - 1][asked % kCandidateKinds])));
    }
  return rows;
}

std::vector<KindShares> stage_shares(const ColumnTrees& stage, std::span<const CandidateFeatures> candidates,
                                     std::span<const CandidateParts> parts, std::span<const KindShares> predicted) {
  const std::vector<CandidateRelations> relations = candidate_relations(candidates, parts);
  std::vector<KindShares> out(candidates.size());
  parallel_for((candidates.size() + kTreesGrain - 1) / kTreesGrain, [&](std::size_t chunk) {
    const std::size_t first = chunk * kTreesGrain, count = std::min(kTreesGrain, candidates.size() - first);
    std::vector<std::int32_t> scores(count * kCandidateKinds);
    tree_scores(stage.trees, role_rows(stage.columns, {candidates, relations, predicted}, first, count), scores);
    for (std::size_t i = 0; i < count; ++i)
      tree_shares(std::span(scores).subspan(i * kCandidateKinds, kCandidateKinds), out[first + i]);
  });
  return out;
}

std::vector<KindShares> kind_shares(const RoleTrees& model, std::span<const CandidateFeatures> candidates,
                                    std::span<const CandidateParts> parts) {
  std::vector<KindShares> predicted;
  for (const ColumnTrees& stage : model.stages) predicted = stage_shares(stage, candidates, parts, predicted);
  return predicted;
}

}  // namespace ilot
