// SPDX-License-Identifier: Apache-2.0
// Sums of small decision trees that tell classes apart. Scores are whole numbers, so a sum is the same in any order.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// A node of a tree: values of the column in a bin above `bin` go right. A node that parts nothing has kNoSplit.
struct TreeSplit {
  std::uint16_t column = 0, bin = 0;
};
constexpr std::uint16_t kNoSplit = 0xffff;  // as a bin: all go left

// Trees of one depth for every class, all of them complete: the tree t adds to class t % classes. Nodes and leaves
// stand level by level, from the left.
struct BoostedTrees {
  std::size_t classes = 0, depth = 0;
  std::vector<std::vector<float>> limits;  // of each column, rising: the bin of a value is how many are less than it
  std::vector<std::int32_t> first;         // of each class: where its sum begins
  std::vector<TreeSplit> splits;           // 2^depth - 1 of each tree
  std::vector<std::int32_t> leaves;        // 2^depth of each tree

  std::size_t trees() const { return leaves.size() >> depth; }
};

constexpr double kTreeUnit = 0x1p-10;  // of what leaves and scores count

// Bins of rows of values, a row after the other, as many values a row as there are lists of limits (at most 255 limits
// each). What is no number is of bin 0. O(values log limits).
std::vector<std::uint8_t> tree_bins(std::span<const std::vector<float>> limits, std::span<const double> rows);

// The score of each class for each row, a row after the other: a share is proportional to exp(kTreeUnit score). O(rows
// trees depth).
void tree_scores(const BoostedTrees& model, std::span<const double> rows, std::span<std::int32_t> scores);

// The shares that scores of one row stand for, which sum to 1 but for rounding. Plain arithmetic.
void tree_shares(std::span<const std::int32_t> scores, std::span<double> shares);

}  // namespace ilot
