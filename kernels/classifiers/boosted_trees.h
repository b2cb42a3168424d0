// SPDX-License-Identifier: Apache-2.0
// Sums of small decision trees that tell classes apart. Scores are whole numbers, so a sum is the same in any order.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// A node of a tree. A row goes right where its value in the column has a bin above `bin`. A node that does not split
// has kNoSplit.
struct TreeSplit {
  std::uint16_t column = 0, bin = 0;
};
constexpr std::uint16_t kNoSplit = 0xffff;  // as a bin: all go left

// Trees of one depth for every class. All trees are complete. Tree t adds to class t % classes. Nodes and leaves are
// stored level by level, from the left.
struct BoostedTrees {
  std::size_t classes = 0, depth = 0;
  std::vector<std::vector<float>> limits;  // of each column, rising; the bin is the number of limits below a value
  std::vector<std::int32_t> first;         // of each class: the start value of its sum
  std::vector<TreeSplit> splits;           // 2^depth - 1 of each tree
  std::vector<std::int32_t> leaves;        // 2^depth of each tree

  std::size_t trees() const { return leaves.size() >> depth; }
};

constexpr double kTreeUnit = 0x1p-10;  // unit of leaves and scores

// Computes the bins of rows of values, one row after the other. A row has as many values as there are lists of limits.
// A list has at most 255 limits. A value that is NaN gets bin 0. O(values log limits).
std::vector<std::uint8_t> tree_bins(std::span<const std::vector<float>> limits, std::span<const double> rows);

// Computes the score of each class for each row, one row after the other. The share of a class is proportional to
// exp(kTreeUnit score). O(rows trees depth).
void tree_scores(const BoostedTrees& model, std::span<const double> rows, std::span<std::int32_t> scores);

// Computes the shares that belong to the scores of one row. They sum to 1 up to rounding. The function uses plain
// arithmetic only.
void tree_shares(std::span<const std::int32_t> scores, std::span<double> shares);

}  // namespace ilot
