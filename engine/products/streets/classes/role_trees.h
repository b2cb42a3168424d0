// SPDX-License-Identifier: Apache-2.0
// The role of a candidate in its tree of joins, found by boosted trees: which candidates are whole, and which of these
// are objects.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/products/streets/objects/object_candidates.h"
#include "kernels/classifiers/boosted_trees.h"

namespace ilot {

// The kinds that the trees distinguish. The class of an object is decided elsewhere.
enum class CandidateKind : std::uint8_t { nothing, vegetation, part, merged, object };
constexpr std::size_t kCandidateKinds = 5;
using KindShares = std::array<double, kCandidateKinds>;  // sum to 1

// The numbers of the candidates that a candidate joins, from 1, as find_object_candidates numbers them; 0: none.
using CandidateParts = std::array<std::uint32_t, 2>;

// The number of stages (stacking; Wolpert 1992). The first stage uses the features of a candidate. The second stage
// also uses the result of the first stage for the candidate itself, for its parts and for its partner.
constexpr std::size_t kRoleStages = 2;

// Trees and the columns that they use. A column is a feature or, from kCandidateFeatures on, the logarithm of a share
// that the first stage of the roles gives.
struct ColumnTrees {
  std::vector<std::size_t> columns;  // indices of the columns that the trees use
  BoostedTrees trees;
  bool empty() const { return trees.splits.empty(); }
};

struct RoleTrees {
  std::array<ColumnTrees, kRoleStages> stages;
  bool empty() const { return stages[0].empty(); }
};

// The candidates whose first-stage result the second stage uses: the candidate itself and its relatives.
enum class CandidateRelation : std::uint8_t { itself, joined, beside, larger_part, lesser_part };
constexpr std::size_t kCandidateRelations = 5;
constexpr std::size_t kRoleColumns = kCandidateFeatures + kCandidateRelations * kCandidateKinds;

// The name of a column, for example "area" or "beside: part".
std::string role_column_name(std::size_t column);

// For each candidate, the numbers (from 1) of its relatives; 0: there is none. Of two parts with equal area the first
// is the larger one.
using CandidateRelations = std::array<std::uint32_t, kCandidateRelations>;
std::vector<CandidateRelations> candidate_relations(std::span<const CandidateFeatures> candidates,
                                                    std::span<const CandidateParts> parts);

// The inputs of a stage. `predicted` is the result of the first stage, for the columns that use it.
struct RoleInputs {
  std::span<const CandidateFeatures> candidates;
  std::span<const CandidateRelations> relations;
  std::span<const KindShares> predicted;
};

// The rows that the trees of a stage use for `count` candidates from `first` on: candidate after candidate, each with
// its columns in their order.
std::vector<double> role_rows(std::span<const std::size_t> columns, const RoleInputs& about, std::size_t first,
                              std::size_t count);

// The shares that one stage gives for all candidates. Runs on the threads of the calling arena.
std::vector<KindShares> stage_shares(const ColumnTrees& stage, std::span<const CandidateFeatures> candidates,
                                     std::span<const CandidateParts> parts, std::span<const KindShares> predicted);

// The shares that the trees give for all candidates; `parts` has one entry per candidate. O(candidates trees), on the
// threads of the calling arena.
std::vector<KindShares> kind_shares(const RoleTrees& model, std::span<const CandidateFeatures> candidates,
                                    std::span<const CandidateParts> parts);

}  // namespace ilot
