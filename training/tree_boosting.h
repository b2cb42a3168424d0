// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernels/classifiers/boosted_trees.h"

namespace ilot {

struct TreeBoostingParams {
  std::size_t rounds = 150;    // trees of each class
  std::size_t depth = 4;       // at most 7
  std::size_t bins = 64;       // of a column, at most 256; each has about the same number of values
  double shrinkage = 0.15;     // factor of what a tree adds
  double ridge = 1;            // added to the curvature of a leaf
  double least_curvature = 1;  // least curvature of a leaf: sum of p (1 - p) over what its rows stand for
  // Gradient-based one-side sampling (Ke et al. 2017): each tree learns from the rows with the largest gradients, at
  // most this share of all, and from one in `drawn_of` of the others, which counts `drawn_of` times. With 1 it learns
  // from all rows.
  double largest_share = 0.2;
  std::uint32_t drawn_of = 1;  // at most kMostDrawnOf
};

constexpr std::uint32_t kMostDrawnOf = 1024;  // a gradient that counts so many times still has 32 bits

// The values of one column for all rows, finite. Called once for each column, from several threads at once.
using ReadColumn = std::function<std::vector<double>(std::size_t column)>;

// The columns of rows that stand one after the other. The rows must outlive the function.
ReadColumn columns_of_rows(std::span<const double> rows, std::size_t columns);

// Values by column and the class of each row.
struct TreeSamples {
  std::size_t columns = 0, classes = 0;
  ReadColumn values;
  std::span<const std::uint32_t> of_class;  // each is below `classes`
};

// Learns trees that separate classes: gradient boosting of the multinomial likelihood by Newton steps (Friedman 2001;
// Chen and Guestrin 2016) on histograms of binned values. Each round learns a tree for each class, from the shares
// before the round. Each tree is learnt level by level. A node is split where the gain is greatest (ties: the lower
// column, then the lower limit), or not at all where there is no gain. Gradients are integer multiples of 2^-20 and are
// summed as such, so the order of the rows and the number of threads do not matter. Limits that no tree uses are left
// out. Rows are drawn by a hash of their bins, the round and the class, so equal rows are drawn together. A class
// without rows is never predicted. O(rounds classes depth (rows + counted rows columns)) at most, because of two nodes
// only the smaller one is counted. Memory is about 8 + 2 columns + 28 classes bytes per row, and 24 more for each
// thread.
BoostedTrees boost_trees(const TreeSamples& samples, const TreeBoostingParams& params = {});

}  // namespace ilot
