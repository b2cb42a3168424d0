// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/tree_errors.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace ilot {
namespace {

// Choice: what has fewer points or is lower cannot be told from a shrub by a person either.
constexpr std::uint64_t kLeastPoints = 20;
constexpr double kLeastTop = 3;                // metres above the foot
constexpr double kNearest = 1, kFarthest = 3;  // metres from the trunk

struct Pair {
  double distance = 0;
  std::size_t truth = 0, found = 0;
};

}  // namespace

TreeResult evaluate_trees(std::span<const TrueTree> truth, const std::map<std::uint32_t, SeenTree>& seen,
                          std::span<const StreetTree> found, double metres_per_unit) {
  TreeResult result;
  const auto sight = [&](const TrueTree& t) {
    const auto known = seen.find(t.id);
    return known == seen.end() ? SeenTree{} : known->second;
  };
  const auto judged = [&](const TrueTree& t) {
    const SeenTree s = sight(t);
    return s.points >= kLeastPoints && (s.top - t.base.z) * metres_per_unit >= kLeastTop;
  };
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    ++(judged(truth[t]) ? result.truth : result.unseen);
    const double most = std::clamp(truth[t].crown_radius_m, kNearest, kFarthest);
    for (std::size_t f = 0; f < found.size(); ++f) {
      const Vec3 d = found[f].position - truth[t].base;
      const double distance = std::hypot(d.x, d.y) * metres_per_unit;
      if (distance <= most) pairs.push_back({distance, t, f});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance, a.truth, a.found) < std::tie(b.distance, b.truth, b.found);
  });
  std::vector<std::uint8_t> used_truth(truth.size(), 0), used_found(found.size(), 0);
  std::vector<double> position, with, without, height, whole, radius, base;
  std::uint64_t not_judged = 0;
  for (const Pair& pair : pairs) {
    if (used_truth[pair.truth] != 0 || used_found[pair.found] != 0) continue;
    used_truth[pair.truth] = used_found[pair.found] = 1;
    const TrueTree& t = truth[pair.truth];
    const StreetTree& f = found[pair.found];
    if (!judged(t)) {
      ++not_judged;
      continue;
    }
    ++result.matched;
    result.trunks += f.trunk_seen;
    position.push_back(pair.distance);
    (f.trunk_seen ? with : without).push_back(pair.distance);
    height.push_back(f.height_m - (sight(t).top - t.base.z) * metres_per_unit);
    whole.push_back(f.height_m - t.height_m);
    radius.push_back(f.crown_radius_m - t.crown_radius_m);
    base.push_back(f.crown_base_m - t.crown_base_m);
  }
  result.found = found.size() - not_judged;
  result.false_found = result.found - result.matched;
  result.position = sizes_of(position);
  result.position_with_trunk = sizes_of(with), result.position_without_trunk = sizes_of(without);
  result.height = sizes_of(height), result.height_of_tree = sizes_of(whole);
  result.crown_radius = sizes_of(radius), result.crown_base = sizes_of(base);
  return result;
}

}  // namespace ilot
