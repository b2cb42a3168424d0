// SPDX-License-Identifier: Apache-2.0
#include "kernels/classifiers/boosted_trees.h"

#include <algorithm>
#include <cassert>

#include "kernels/core/portable_math.h"

namespace ilot {

std::vector<std::uint8_t> tree_bins(std::span<const std::vector<float>> limits, std::span<const double> rows) {
  assert(!limits.empty() && rows.size() % limits.size() == 0);
  std::vector<std::uint8_t> bins(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<float>& list = limits[i % limits.size()];
    assert(list.size() <= 255);
    const auto above = std::partition_point(list.begin(), list.end(), [&](float limit) { return limit < rows[i]; });
    bins[i] = static_cast<std::uint8_t>(above - list.begin());
  }
  return bins;
}

void tree_scores(const BoostedTrees& model, std::span<const double> rows, std::span<std::int32_t> scores) {
  const std::size_t columns = model.limits.size(), classes = model.classes, leaves = std::size_t{1} << model.depth;
  const std::vector<std::uint8_t> bins = tree_bins(model.limits, rows);
  const std::size_t count = rows.size() / columns, trees = model.trees();
  assert(scores.size() == count * classes && model.splits.size() == trees * (leaves - 1));
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t c = 0; c < classes; ++c) scores[r * classes + c] = model.first[c];
  for (std::size_t t = 0; t < trees; ++t) {
    const TreeSplit* splits = model.splits.data() + t * (leaves - 1);
    const std::int32_t* leaf = model.leaves.data() + t * leaves;
    for (std::size_t r = 0; r < count; ++r) {
      const std::uint8_t* row = bins.data() + r * columns;
      std::size_t node = 0;
      for (std::size_t level = 0; level < model.depth; ++level)
        node = 2 * node + 1 + (row[splits[node].column] > splits[node].bin);
      // A model has a class or more. NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
      scores[r * classes + t % classes] += leaf[node - (leaves - 1)];
    }
  }
}

void tree_shares(std::span<const std::int32_t> scores, std::span<double> shares) {
  assert(scores.size() == shares.size());
  const std::int32_t most = *std::max_element(scores.begin(), scores.end());
  double sum = 0;
  for (std::size_t c = 0; c < scores.size(); ++c) {
    const double below = kTreeUnit * (static_cast<double>(scores[c]) - static_cast<double>(most));
    sum += shares[c] = natural_exp(std::max(-700.0, below));
  }
  for (double& s : shares) s /= sum;
}

}  // namespace ilot
