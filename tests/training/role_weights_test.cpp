// SPDX-License-Identifier: Apache-2.0
#include "training/role_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// The sum over all cuts of the tree of a thing, one by one; `may` as in the sample or all.
double sum_of_cuts(const std::vector<RoleSample>& candidates, const RoleWeights& w, std::size_t root,
                   bool only_allowed) {
  const auto weight = [&](std::size_t i, std::size_t s) {
    return only_allowed && candidates[i].may[s] == 0 ? 0.0 : std::exp(w.power[s] * candidates[i].log[s] + w.bias[s]);
  };
  const auto parts = [&](auto&& self, std::size_t i) -> double {
    double p = weight(i, 2);
    for (const std::uint32_t part : candidates[i].parts)
      if (part != 0) p *= self(self, part - 1);
    return p;
  };
  double whole = weight(root, 0) + weight(root, 1), merged = weight(root, 3);
  for (const std::uint32_t part : candidates[root].parts) {
    if (part == 0) return whole;
    whole *= parts(parts, part - 1);
    merged *= sum_of_cuts(candidates, w, part - 1, only_allowed);
  }
  return whole + merged;
}

double cost_of(const std::vector<RoleSample>& candidates, const std::vector<std::size_t>& roots, const RoleWeights& w) {
  double cost = 0;
  for (std::size_t s = 0; s < kCandidateStates; ++s)
    cost += ((w.power[s] - 1) * (w.power[s] - 1) + w.bias[s] * w.bias[s]) / 2;
  for (const std::size_t root : roots) {
    const double allowed = sum_of_cuts(candidates, w, root, true);
    if (allowed > 0) cost -= std::log(allowed / sum_of_cuts(candidates, w, root, false));
  }
  return cost;
}

// Two or three parts joined to one; the last tree has no cut that is allowed.
std::vector<RoleSample> drawn_trees(std::size_t trees, std::vector<std::size_t>& roots) {
  Rng rng(11);
  std::vector<RoleSample> candidates;
  for (std::size_t t = 0; t < trees; ++t) {
    const auto first = static_cast<std::uint32_t>(candidates.size());
    const bool three = rng.below(2) == 0, whole = rng.below(2) == 0;
    for (std::uint32_t i = 0; i < (three ? 5u : 3u); ++i) {
      RoleSample s;
      for (double& v : s.log) v = std::log(0.02 + rng.uniform());
      const bool joined = i >= (three ? 3u : 2u);
      if (joined && i == (three ? 3u : 2u)) s.parts[0] = first + 1, s.parts[1] = first + 2;
      if (i == 4) s.parts[0] = first + 4, s.parts[1] = first + 3;
      const bool root = i == (three ? 4u : 2u);
      if (whole) s.may = root ? std::array<std::uint8_t, 4>{1, 0, 0, 0} : std::array<std::uint8_t, 4>{0, 0, 1, 0};
      if (!whole && root) s.may = {0, 0, 0, 1};
      if (whole != root) s.log[0] += 1;  // what classifiers say tells something
      candidates.push_back(s);
    }
    roots.push_back(candidates.size() - 1);
  }
  candidates.back().may = {0, 0, 0, 0};
  return candidates;
}

TEST(RoleWeights, NoneNearAreBetter) {
  std::vector<std::size_t> roots;
  const std::vector<RoleSample> candidates = drawn_trees(60, roots);
  const RoleWeights found = learn_role_weights(candidates);
  const double least = cost_of(candidates, roots, found);
  EXPECT_LT(least, cost_of(candidates, roots, {}) - 1);
  for (std::size_t s = 0; s < kCandidateStates; ++s)
    for (const double d : {-0.02, 0.02}) {
      RoleWeights other = found;
      other.power[s] += d;
      EXPECT_GT(cost_of(candidates, roots, other), least) << s;
      other = found;
      other.bias[s] += d;
      EXPECT_GT(cost_of(candidates, roots, other), least) << s;
    }
}

TEST(RoleWeights, NothingToLearnFrom) {
  for (const RoleWeights& w : {learn_role_weights({}), learn_role_weights(std::vector<RoleSample>(3))}) {
    EXPECT_EQ(w.power, RoleWeights{}.power);
    EXPECT_EQ(w.bias, RoleWeights{}.bias);
  }
}

}  // namespace
}  // namespace ilot
