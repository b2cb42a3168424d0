// SPDX-License-Identifier: Apache-2.0
#include "kernels/classifiers/boosted_trees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ilot {
namespace {

// Two classes, two columns: one tree each of depth 2, the first's right side parts no more.
BoostedTrees two_trees() {
  BoostedTrees m;
  m.classes = 2, m.depth = 2;
  m.limits = {{1, 3}, {10}};
  m.first = {100, -100};
  m.splits = {{0, 1}, {1, 0}, {0, kNoSplit}, {1, 0}, {0, kNoSplit}, {0, 0}};
  m.leaves = {1, 2, 4, 8, 16, 32, 64, 128};
  return m;
}

TEST(TreeBins, CountTheLimitsThatAreLess) {
  const std::vector<std::vector<float>> limits{{1, 3}, {}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> rows{0, 5, 1, 5, 1.5, 5, 3, nan, 4, 5, nan, 5};
  EXPECT_EQ(tree_bins(limits, rows), (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 1, 0, 2, 0, 0, 0}));
}

TEST(TreeScores, AreReadOffByHand) {
  const std::vector<double> rows{2, 5, 2, 11, 4, 11, 0, 11};
  std::vector<std::int32_t> scores(8, 7);
  tree_scores(two_trees(), rows, scores);
  // 2, 5: left, left: 1; second: left, left: 16. 2, 11: left, right: 2; right, right: 128. 4, 11: right: 4; 128.
  // 0, 11: 2; right, left: 64.
  EXPECT_EQ(scores, (std::vector<std::int32_t>{101, -84, 102, 28, 104, 28, 102, -36}));
}

TEST(TreeScores, OfNoTreesAndOfNoRows) {
  BoostedTrees m = two_trees();
  tree_scores(m, {}, {});
  m.splits.clear(), m.leaves.clear();
  std::vector<std::int32_t> scores(2);
  tree_scores(m, std::vector<double>{1, 2}, scores);
  EXPECT_EQ(scores, m.first);
}

TEST(TreeShares, AreProportionalToTheirExponentials) {
  const std::vector<std::int32_t> scores{2048, 1024, -3000000};
  std::vector<double> shares(3);
  tree_shares(scores, shares);
  EXPECT_NEAR(shares[0] / shares[1], std::exp(1.0), 1e-12);
  EXPECT_NEAR(shares[0] + shares[1], 1, 1e-12);
  EXPECT_LT(shares[2], 1e-300);
}

}  // namespace
}  // namespace ilot
