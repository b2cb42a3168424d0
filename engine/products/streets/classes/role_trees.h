// SPDX-License-Identifier: Apache-2.0
// What a thing is in its tree of joins, by boosted trees: which things are whole, and of these which are objects.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "kernels/classifiers/boosted_trees.h"

namespace ilot {

// What trees tell apart. An object's class is another matter.
enum class CandidateKind : std::uint8_t { nothing, vegetation, part, merged, object };
constexpr std::size_t kCandidateKinds = 5;
using KindShares = std::array<double, kCandidateKinds>;  // sum to 1

// Numbers of the things that a thing joins, from 1; 0: none, as find_object_candidates numbers them.
using CandidateParts = std::array<std::uint32_t, 2>;

// The first stage knows a thing's features, the second knows besides what the first says of it and of those that it is
// joined from and with (stacking; Wolpert 1992).
constexpr std::size_t kRoleStages = 2;

// A column is a feature, or, from kCandidateFeatures on, the logarithm of a share that the first stage gives.
struct RoleStage {
  std::vector<std::size_t> columns;  // of the trees
  BoostedTrees trees;
};

struct RoleTrees {
  std::array<RoleStage, kRoleStages> stages;
  bool empty() const { return stages[0].trees.splits.empty(); }
};

// Whom the second stage asks about, besides the thing itself.
enum class CandidateRelation : std::uint8_t { itself, joined, beside, larger_part, lesser_part };
constexpr std::size_t kCandidateRelations = 5;
constexpr std::size_t kRoleColumns = kCandidateFeatures + kCandidateRelations * kCandidateKinds;

// "area", or "beside: part".
std::string role_column_name(std::size_t column);

// Of each thing, from 1, the thing that stands so to it; 0: there is none. Of two parts of one area the first is the
// larger.
using CandidateRelations = std::array<std::uint32_t, kCandidateRelations>;
std::vector<CandidateRelations> candidate_relations(std::span<const CandidateFeatures> candidates,
                                                    std::span<const CandidateParts> parts);

// What a stage may ask about: `said` by the first stage, for columns that ask for it.
struct RoleInputs {
  std::span<const CandidateFeatures> candidates;
  std::span<const CandidateRelations> relations;
  std::span<const KindShares> predicted;
};

// The rows that a stage's trees see of `count` things from `first` on, a thing after the other, its columns in their
// order.
std::vector<double> role_rows(std::span<const std::size_t> columns, const RoleInputs& about, std::size_t first,
                              std::size_t count);

// What one stage says of all things. On the threads of the calling arena.
std::vector<KindShares> stage_shares(const RoleStage& stage, std::span<const CandidateFeatures> candidates,
                                     std::span<const CandidateParts> parts, std::span<const KindShares> predicted);

// What the trees say of all things; parts for each of them. O(things trees), on the threads of the calling arena.
std::vector<KindShares> kind_shares(const RoleTrees& model, std::span<const CandidateFeatures> candidates,
                                    std::span<const CandidateParts> parts);

}  // namespace ilot
