// SPDX-License-Identifier: Apache-2.0
#include "training/tree_boosting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

struct Set {
  std::size_t columns = 0, classes = 0;
  std::vector<double> values;
  std::vector<std::uint32_t> of_class;
  TreeSamples samples() const { return {columns, classes, columns_of_rows(values, columns), of_class}; }
};

// Values of few digits, so that many are equal; the class hangs on two columns and on chance.
Set drawn(std::size_t rows, std::size_t columns, std::size_t classes, std::uint64_t seed) {
  Set s{columns, classes, {}, {}};
  Rng rng(seed, 9);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) s.values.push_back(std::floor(40 * rng.uniform()) / 8);
    const double* row = s.values.data() + r * columns;
    const bool high = row[0] > 2.5, far = row[columns - 1] > 1;
    s.of_class.push_back(static_cast<std::uint32_t>(rng.below(5) == 0 ? rng.below(classes) : (high + far) % classes));
  }
  return s;
}

std::vector<std::int32_t> scores_of(const BoostedTrees& m, const Set& s) {
  std::vector<std::int32_t> out(s.of_class.size() * m.classes);
  tree_scores(m, s.values, out);
  return out;
}

// What training lowers: the mean over the rows of -ln of the share of their class.
double tree_loss(const BoostedTrees& model, const Set& s) {
  const std::vector<std::int32_t> scores = scores_of(model, s);
  std::vector<double> share(model.classes);
  double sum = 0;
  for (std::size_t r = 0; r < s.of_class.size(); ++r) {
    tree_shares(std::span(scores).subspan(r * model.classes, model.classes), share);
    sum -= std::log(share[s.of_class[r]]);
  }
  return sum / static_cast<double>(s.of_class.size());
}

void expect_same(const BoostedTrees& a, const BoostedTrees& b) {
  EXPECT_EQ(a.limits, b.limits);
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.leaves, b.leaves);
  ASSERT_EQ(a.splits.size(), b.splits.size());
  for (std::size_t i = 0; i < a.splits.size(); ++i) {
    EXPECT_EQ(a.splits[i].column, b.splits[i].column);
    EXPECT_EQ(a.splits[i].bin, b.splits[i].bin);
  }
}

// The gain of parting all rows at a value of a column, by the definition.
double gain_at(const Set& s, std::uint32_t of_class, std::size_t column, double limit, double share,
               const TreeBoostingParams& params) {
  double g[2] = {0, 0}, h[2] = {0, 0};
  for (std::size_t r = 0; r < s.of_class.size(); ++r) {
    const bool right = s.values[r * s.columns + column] > limit;
    g[right] += share - (s.of_class[r] == of_class);
    h[right] += share * (1 - share);
  }
  if (std::min(h[0], h[1]) < params.least_curvature) return 0;
  const auto score = [&](double a, double b) { return a * a / (b + params.ridge); };
  return score(g[0], h[0]) + score(g[1], h[1]) - score(g[0] + g[1], h[0] + h[1]);
}

TEST(TreeBoosting, TheFirstSplitIsTheBestOfAll) {
  TreeBoostingParams params;
  params.rounds = 1, params.depth = 1, params.bins = 256;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Set s = drawn(300, 4, 3, seed);
    const BoostedTrees m = boost_trees(s.samples(), params);
    for (std::uint32_t c = 0; c < s.classes; ++c) {
      const double share = static_cast<double>(std::count(s.of_class.begin(), s.of_class.end(), c)) / 300;
      double best = 0;
      for (std::size_t column = 0; column < s.columns; ++column)
        for (const double limit : s.values) best = std::max(best, gain_at(s, c, column, limit, share, params));
      ASSERT_GT(best, 0);
      const TreeSplit split = m.splits[c];
      ASSERT_NE(split.bin, kNoSplit);
      const double limit = m.limits[split.column][split.bin];
      EXPECT_NEAR(gain_at(s, c, split.column, limit, share, params), best, 0.01 * best);  // shares of first are rounded
      double g = 0, h = 0;
      for (std::size_t r = 0; r < 300; ++r) {
        if (s.values[r * s.columns + split.column] <= limit) continue;
        g += share - (s.of_class[r] == c), h += share * (1 - share);
      }
      EXPECT_NEAR(kTreeUnit * m.leaves[2 * c + 1], -params.shrinkage * g / (h + params.ridge), 2e-3);
    }
  }
}

TEST(TreeBoosting, EachRoundLowersTheLoss) {
  const Set s = drawn(600, 5, 3, 4);
  double before = 10;
  for (const std::size_t rounds : {0u, 1u, 2u, 5u, 20u, 60u}) {
    TreeBoostingParams params;
    params.rounds = rounds;
    const double loss = tree_loss(boost_trees(s.samples(), params), s);
    EXPECT_LT(loss, before);
    before = loss;
  }
  EXPECT_LT(tree_loss(boost_trees(s.samples()), drawn(600, 5, 3, 5)), 0.75);  // not seen; 1.05 without trees
}

// Trees that learn from a third of the rows are nearly as good where there are many rows.
TEST(TreeBoosting, DrawnRowsStandForTheOthers) {
  const Set s = drawn(20000, 5, 3, 8), unseen = drawn(5000, 5, 3, 9);
  TreeBoostingParams params;
  params.rounds = 40;
  const double all = tree_loss(boost_trees(s.samples(), params), unseen);
  params.drawn_of = 8;
  const double of_drawn = tree_loss(boost_trees(s.samples(), params), unseen);
  EXPECT_LT(of_drawn, 1.02 * all);
  EXPECT_NE(of_drawn, all);
  params.largest_share = 0, params.drawn_of = kMostDrawnOf;  // some twenty rows a tree cannot stand for all
  EXPECT_GT(tree_loss(boost_trees(s.samples(), params), unseen), 1.1 * all);
}

TEST(TreeBoosting, NeitherOrderNorThreadsShow) {
  const Set s = drawn(700, 3, 4, 6);
  Set turned{s.columns, s.classes, {}, {}};
  for (std::size_t i = 0; i < 700; ++i) {
    const std::size_t r = i * 443 % 700;
    turned.values.insert(turned.values.end(), s.values.begin() + static_cast<std::ptrdiff_t>(r * 3),
                         s.values.begin() + static_cast<std::ptrdiff_t>(r * 3 + 3));
    turned.of_class.push_back(s.of_class[r]);
  }
  for (const std::uint32_t drawn_of : {1u, 4u}) {
    TreeBoostingParams params;
    params.drawn_of = drawn_of;
    BoostedTrees one, three;
    with_threads(1, [&] { one = boost_trees(s.samples(), params); });
    with_threads(3, [&] { three = boost_trees(s.samples(), params); });
    expect_same(one, three);
    expect_same(one, boost_trees(turned.samples(), params));
  }
}

TEST(TreeBoosting, LimitsThatNoTreeAsksForAreLeftOut) {
  TreeBoostingParams params;
  params.rounds = 2, params.depth = 2;
  Set s = drawn(400, 6, 2, 7);
  const BoostedTrees m = boost_trees(s.samples(), params);
  std::size_t limits = 0;
  for (const auto& list : m.limits) limits += list.size();
  EXPECT_LE(limits, m.splits.size());
  for (const TreeSplit split : m.splits) {
    if (split.bin != kNoSplit) {
      EXPECT_LT(split.bin, m.limits[split.column].size());
    }
  }
}

// What cannot be told apart is as common as it was; and one value has no limits.
TEST(TreeBoosting, WithoutInformativeFeatures) {
  Set s{2, 2, std::vector<double>(80, 3), {}};
  for (std::size_t r = 0; r < 40; ++r) s.of_class.push_back(r % 4 == 0);
  const BoostedTrees m = boost_trees(s.samples());
  std::vector<double> shares(2);
  const std::vector<std::int32_t> scores = scores_of(m, s);
  tree_shares(std::span(scores).first(2), shares);
  EXPECT_NEAR(shares[1], 0.25, 1e-3);
  EXPECT_TRUE(m.limits[0].empty());
}

}  // namespace
}  // namespace ilot
