// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/class_shares.h"

#include <algorithm>

#include "engine/products/streets/classes/object_model_functions.h"
#include "engine/products/streets/classes/pair_coupling.h"
#include "engine/products/streets/classes/svm_decisions.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr std::size_t kSharesGrain = 256;  // candidates

std::vector<ClassShares> shares_of_machine(const ObjectModel& model, std::span<const CandidateFeatures> candidates) {
  const PairDecisions decided = pair_decisions(model, candidates);
  std::vector<ClassShares> out(candidates.size());
  parallel_for((candidates.size() + kSharesGrain - 1) / kSharesGrain, [&](std::size_t part) {
    std::vector<double> first(decided.pairs);
    for (std::size_t i = part * kSharesGrain; i < std::min(candidates.size(), (part + 1) * kSharesGrain); ++i) {
      for (std::size_t p = 0; p < decided.pairs; ++p)
        first[p] = sigmoid(model.slope[p] * decided.of[i * decided.pairs + p] + model.offset[p]);
      const std::size_t k = model.classes.size();
      const auto near = decided.nearest.begin() + static_cast<std::ptrdiff_t>(i * k);
      out[i] = {coupled_pairs(first, k), {near, near + static_cast<std::ptrdiff_t>(k)}};
      double sum = 0;
      for (std::size_t c = 0; c < out[i].share.size(); ++c) sum += out[i].share[c] *= model.prior[c];
      for (double& s : out[i].share) s /= sum;
    }
  });
  return out;
}

// For each class the kernel to its nearest sample; 1 where the model has no samples.
std::vector<double> nearest_samples(const ObjectModel& model, const CandidateFeatures& features) {
  std::vector<double> nearest(model.classes.size(), model.vectors.empty() ? 1 : 0);
  const std::vector<double> row = standardised(model, features);
  for (std::size_t v = 0; v < model.vectors.size(); ++v) {
    double& best = nearest[model.class_of_vector[v]];
    best = std::max(best, radial(row, model.vectors[v], model.gamma));
  }
  return nearest;
}

std::vector<ClassShares> shares_of_trees(const ObjectModel& model, std::span<const CandidateFeatures> candidates) {
  const std::size_t k = model.classes.size();
  std::vector<ClassShares> out(candidates.size(), {std::vector<double>(k), {}});
  parallel_for((candidates.size() + kSharesGrain - 1) / kSharesGrain, [&](std::size_t part) {
    const std::size_t first = part * kSharesGrain, count = std::min(kSharesGrain, candidates.size() - first);
    std::vector<std::int32_t> scores(count * k);
    tree_scores(model.class_trees.trees, feature_rows(model.class_trees.columns, candidates.subspan(first, count)),
                scores);
    for (std::size_t i = 0; i < count; ++i) {
      tree_shares(std::span(scores).subspan(i * k, k), out[first + i].share);
      out[first + i].nearest = nearest_samples(model, candidates[first + i]);
    }
  });
  return out;
}

}  // namespace

std::vector<double> feature_rows(std::span<const std::size_t> features, std::span<const CandidateFeatures> candidates) {
  std::vector<double> rows;
  for (const CandidateFeatures& c : candidates)
    for (const std::size_t f : features) rows.push_back(c[f]);
  return rows;
}

std::vector<ClassShares> class_shares(const ObjectModel& model, std::span<const CandidateFeatures> candidates) {
  if (model.classes.size() == 1) return std::vector<ClassShares>(candidates.size(), ClassShares{{1}, {1}});
  return model.class_trees.empty() ? shares_of_machine(model, candidates) : shares_of_trees(model, candidates);
}

}  // namespace ilot
