// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/component_candidates.h"

#include <algorithm>

#include "engine/products/streets/objects/candidate_description.h"
#include "engine/products/streets/objects/candidate_relations.h"
#include "engine/products/streets/objects/columns.h"
#include "engine/products/streets/objects/part_contacts.h"
#include "engine/products/streets/objects/part_joins.h"
#include "kernels/rasters/gradient.h"

namespace ilot {
namespace {

// The level of each part and each join, which is the greatest number of nested joins in its tree. Candidates of one
// level have no pixel in common.
std::vector<std::uint32_t> levels_of(std::uint32_t parts, const std::vector<Join>& joins) {
  std::vector<std::uint32_t> level(parts + joins.size() + 1, 0);
  for (std::uint32_t j = 0; j < joins.size(); ++j)
    level[parts + j + 1] = 1 + std::max(level[joins[j].a], level[joins[j].b]);
  return level;
}

// Gives pixels the numbers of the joins of one level. Joins that are new at this level get labels of their own in the
// result; `who` is the join of each label.
PixelLabels join_level(const std::vector<std::uint32_t>& becomes, PixelLabels& of, std::vector<std::uint32_t>& who) {
  PixelLabels joined{of.width, of.height, 0, std::vector<std::uint32_t>(of.of.size(), 0)};
  std::vector<std::uint32_t> number(becomes.size(), 0);
  for (std::size_t i = 0; i < of.of.size(); ++i) {
    const std::uint32_t next = becomes[of.of[i]];
    if (next == 0) continue;
    of.of[i] = next;
    if (number[next] == 0) {
      number[next] = ++joined.count;
      who.push_back(next);
    }
    joined.of[i] = number[next];
  }
  return joined;
}

void set_passes(const Joins& joins, std::size_t parts, std::vector<ObjectCandidate>& candidates) {
  const auto inner = static_cast<std::size_t>(CandidateFeature::inner_pass),
             outer = static_cast<std::size_t>(CandidateFeature::outer_pass);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    candidates[i].features[inner] = 1;
    candidates[i].features[outer] = std::max(0.0, joins.outer[i + 1]);
    if (i < parts) continue;
    const Join& join = joins.list[i - parts];
    candidates[i].parts[0] = join.a;
    candidates[i].parts[1] = join.b;
    candidates[i].features[inner] = std::min(
        {std::max(0.0, join.pass), candidates[join.a - 1].features[inner], candidates[join.b - 1].features[inner]});
  }
}

// Whether a component is smaller than a top and has too few points for an object.
bool is_speck(const ComponentImages& images, const RasterScale& scale, const ObjectCandidateParams& params) {
  std::uint64_t pixels = 0, points = 0;
  for (std::size_t i = 0; i < images.own.size(); ++i) {
    if (images.own.values[i] == kNoHeight) continue;
    ++pixels;
    points += static_cast<std::uint64_t>(std::max(0, images.patch.above.values[i]));
  }
  return pixels < scale.area(params.separation.least_top) && points < params.least_points;
}

std::vector<Occupancy> occupancy_of(const ComponentImages& images) {
  std::vector<Occupancy> out(images.own.size(), 0);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (images.own.values[i] != kNoHeight) out[i] = static_cast<Occupancy>(images.patch.occupancy.values[i]);
  return out;
}

}  // namespace

std::uint32_t gap_reach(const RasterScale& scale, const ObjectCandidateParams& params) {
  return std::max(scale.pixels(params.nearest_apart), params.pixels_apart) / 2;
}

ComponentCandidates candidates_of_component(const Patch& patch, std::uint32_t component, const RasterScale& scale,
                                            const ObjectCandidateParams& params) {
  ComponentImages images{patch, patch.height, {}};
  for (std::size_t i = 0; i < images.own.size(); ++i)
    if (static_cast<std::uint32_t>(patch.components.values[i]) != component) images.own.values[i] = kNoHeight;
  if (is_speck(images, scale, params))
    return {{patch.height.width, patch.height.height, 0, std::vector<std::uint32_t>(patch.height.size(), 0)}, {}};
  images.slope = gradient(images.own, Adjacency::eight);
  const std::vector<Occupancy> occupancy = occupancy_of(images);
  ComponentCandidates out{separate_artefacts(images.own, scale, params.separation), {}};
  const std::uint32_t least = scale.area(params.separation.least_top);
  std::vector<ColumnCut> cuts;
  if (params.columns_apart)
    cuts = cut_columns(columns_of(occupancy, out.labels.width, out.labels.height, scale, params.columns), least,
                       out.labels);
  out.candidates = describe(out.labels, images, scale, params);
  const auto parts = static_cast<std::uint32_t>(out.candidates.size());
  const Joins joins = joins_of(out.labels, images.own, 2 * gap_reach(scale, params),
                               params.largest / (scale.pixel * scale.pixel), cuts);
  const std::vector<std::uint32_t> level = levels_of(parts, joins.list);
  out.candidates.resize(parts + joins.list.size());
  PixelLabels of = out.labels;
  for (std::uint32_t l = 1; l <= *std::max_element(level.begin(), level.end()); ++l) {
    std::vector<std::uint32_t> becomes(level.size(), 0), who;
    for (std::uint32_t j = 0; j < joins.list.size(); ++j)
      if (level[parts + j + 1] == l) becomes[joins.list[j].a] = becomes[joins.list[j].b] = parts + j + 1;
    const PixelLabels joined = join_level(becomes, of, who);
    const std::vector<ObjectCandidate> described = describe(joined, images, scale, params);
    for (std::size_t i = 0; i < who.size(); ++i) out.candidates[who[i] - 1] = described[i];
  }
  set_passes(joins, parts, out.candidates);
  set_contacts(out.labels, occupancy, joins.list, scale, out.candidates);
  relate_candidates(out.candidates);
  return out;
}

}  // namespace ilot
