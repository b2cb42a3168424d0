// SPDX-License-Identifier: Apache-2.0
// What a thing is in its tree of joins, by boosted trees: which things are whole, and of these which are objects.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/products/streets/objects/things.h"
#include "kernels/machines/boosted_trees.h"

namespace ilot {

// What trees tell apart. An object's class is another matter.
enum class ThingNature : std::uint8_t { nothing, vegetation, part, several, object };
constexpr std::size_t kThingNatures = 5;
using NatureShares = std::array<double, kThingNatures>;  // sum to 1

// Numbers of the things that a thing joins, from 1; 0: none, as find_things numbers them.
using ThingParts = std::array<std::uint32_t, 2>;

// The first stage knows a thing's features, the second knows besides what the first says of it and of those that it is
// joined from and with (stacking; Wolpert 1992).
constexpr std::size_t kRoleStages = 2;

// A column is a feature, or, from kThingFeatures on, the logarithm of a share that the first stage gives.
struct RoleStage {
  std::vector<std::size_t> columns;  // of the trees
  BoostedTrees trees;
};

struct RoleTrees {
  std::array<RoleStage, kRoleStages> stages;
  bool empty() const { return stages[0].trees.splits.empty(); }
};

// Whom the second stage asks about, besides the thing itself.
enum class ThingRelation : std::uint8_t { itself, joined, beside, larger_part, lesser_part };
constexpr std::size_t kThingRelations = 5;
constexpr std::size_t kRoleColumns = kThingFeatures + kThingRelations * kThingNatures;

// "area", or "beside: part".
std::string role_column_name(std::size_t column);

// Of each thing, from 1, the thing that stands so to it; 0: there is none. Of two parts of one area the first is the
// larger.
using ThingRelations = std::array<std::uint32_t, kThingRelations>;
std::vector<ThingRelations> thing_relations(std::span<const ThingFeatures> things, std::span<const ThingParts> parts);

// What a stage may ask about: `said` by the first stage, for columns that ask for it.
struct RoleQuestions {
  std::span<const ThingFeatures> things;
  std::span<const ThingRelations> relations;
  std::span<const NatureShares> said;
};

// The rows that a stage's trees see of `count` things from `first` on, a thing after the other, its columns in their
// order.
std::vector<double> role_rows(std::span<const std::size_t> columns, const RoleQuestions& about, std::size_t first,
                              std::size_t count);

// What one stage says of all things. On the threads of the calling arena.
std::vector<NatureShares> stage_shares(const RoleStage& stage, std::span<const ThingFeatures> things,
                                       std::span<const ThingParts> parts, std::span<const NatureShares> said);

// What the trees say of all things; parts for each of them. O(things trees), on the threads of the calling arena.
std::vector<NatureShares> nature_shares(const RoleTrees& machine, std::span<const ThingFeatures> things,
                                        std::span<const ThingParts> parts);

}  // namespace ilot
