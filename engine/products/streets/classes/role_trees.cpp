// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/role_trees.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::size_t kGrain = 512;   // things
constexpr double kLeastShare = 1e-6;  // nothing is less probable
constexpr double kNobody = -1e6;      // below all logarithms of shares
constexpr const char* kNatures[] = {"nothing", "vegetation", "part", "several", "object"};
constexpr const char* kRelations[] = {"itself", "joined", "beside", "larger part", "lesser part"};

double area_of(const ThingFeatures& f) {
  return f[static_cast<std::size_t>(ComponentFeature::area)];
}

}  // namespace

std::string role_column_name(std::size_t column) {
  if (column < kThingFeatures) return thing_feature_name(column);
  const std::size_t asked = column - kThingFeatures;
  return std::string(kRelations[asked / kThingNatures]) + ": " + kNatures[asked % kThingNatures];
}

std::vector<ThingRelations> thing_relations(std::span<const ThingFeatures> things, std::span<const ThingParts> parts) {
  assert(parts.size() == things.size());
  std::vector<ThingRelations> out(things.size());
  const auto set = [&](std::uint32_t thing, ThingRelation relation, std::uint32_t to) {
    out[thing - 1][static_cast<std::size_t>(relation)] = to;
  };
  for (std::uint32_t i = 1; i <= things.size(); ++i) {
    set(i, ThingRelation::itself, i);
    const auto [a, b] = parts[i - 1];
    if (a == 0) continue;
    const bool first = area_of(things[a - 1]) >= area_of(things[b - 1]);
    set(i, ThingRelation::larger_part, first ? a : b);
    set(i, ThingRelation::lesser_part, first ? b : a);
    set(a, ThingRelation::beside, b), set(b, ThingRelation::beside, a);
    for (const std::uint32_t part : {a, b}) set(part, ThingRelation::joined, i);
  }
  return out;
}

std::vector<double> role_rows(std::span<const std::size_t> columns, const RoleQuestions& about, std::size_t first,
                              std::size_t count) {
  std::vector<double> rows;
  rows.reserve(columns.size() * count);
  for (std::size_t i = first; i < first + count; ++i)
    for (const std::size_t c : columns) {
      if (c < kThingFeatures) {
        rows.push_back(about.things[i][c]);
        continue;
      }
      const std::size_t asked = c - kThingFeatures;
      const std::uint32_t whom = about.relations[i][asked / kThingNatures];
      rows.push_back(whom == 0 ? kNobody
                               : natural_log(std::max(kLeastShare, about.said[whom - 1][asked % kThingNatures])));
    }
  return rows;
}

std::vector<NatureShares> stage_shares(const RoleStage& stage, std::span<const ThingFeatures> things,
                                       std::span<const ThingParts> parts, std::span<const NatureShares> said) {
  const std::vector<ThingRelations> relations = thing_relations(things, parts);
  std::vector<NatureShares> out(things.size());
  parallel_for((things.size() + kGrain - 1) / kGrain, [&](std::size_t chunk) {
    const std::size_t first = chunk * kGrain, count = std::min(kGrain, things.size() - first);
    std::vector<std::int32_t> scores(count * kThingNatures);
    tree_scores(stage.trees, role_rows(stage.columns, {things, relations, said}, first, count), scores);
    for (std::size_t i = 0; i < count; ++i)
      tree_shares(std::span(scores).subspan(i * kThingNatures, kThingNatures), out[first + i]);
  });
  return out;
}

std::vector<NatureShares> nature_shares(const RoleTrees& machine, std::span<const ThingFeatures> things,
                                        std::span<const ThingParts> parts) {
  std::vector<NatureShares> said;
  for (const RoleStage& stage : machine.stages) said = stage_shares(stage, things, parts, said);
  return said;
}

}  // namespace ilot
