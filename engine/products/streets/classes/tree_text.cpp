// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/tree_text.h"

#include <fmt/format.h>

#include <cmath>

namespace ilot {
namespace {

constexpr std::size_t kMostDepth = 7;
constexpr std::size_t kMostLimits = 255;

// Parses "-", or a column and one of its limits.
bool split_of(const std::string& word, const BoostedTrees& trees, TreeSplit& split) {
  split = {0, kNoSplit};
  if (word == "-") return true;
  const std::size_t colon = word.find(':');
  return colon != std::string::npos && number_of(std::string_view(word).substr(0, colon), split.column) &&
         number_of(std::string_view(word).substr(colon + 1), split.bin) && split.column < trees.limits.size() &&
         split.bin < trees.limits[split.column].size();
}

}  // namespace

std::string tree_start_text(const BoostedTrees& trees) {
  return fmt::format("{} {}\n", trees.depth, fmt::join(trees.first, " "));
}

std::string tree_column_text(const BoostedTrees& trees, std::size_t column, const std::string& name) {
  std::string text = fmt::format("column {}", trees.limits[column].size());
  for (const float limit : trees.limits[column]) text += fmt::format(" {:.9g}", limit);
  return text + " " + name + "\n";
}

std::string tree_nodes_text(const BoostedTrees& trees) {
  std::string text;
  const std::size_t leaves = std::size_t{1} << trees.depth;
  for (std::size_t t = 0; t < trees.trees(); ++t) {
    text += "tree";
    for (std::size_t n = t * (leaves - 1); n < (t + 1) * (leaves - 1); ++n)
      text +=
          trees.splits[n].bin == kNoSplit ? " -" : fmt::format(" {}:{}", trees.splits[n].column, trees.splits[n].bin);
    for (std::size_t n = t * leaves; n < (t + 1) * leaves; ++n) text += fmt::format(" {}", trees.leaves[n]);
    text += "\n";
  }
  return text;
}

std::string take_tree_start(std::istringstream& words, std::size_t classes, BoostedTrees& trees) {
  trees.classes = classes;
  trees.first.resize(classes);
  if (!next_number(words, trees.depth) || trees.depth == 0 || trees.depth > kMostDepth) return "there is no such depth";
  for (std::int32_t& first : trees.first)
    if (!next_number(words, first)) return fmt::format("fewer than {} numbers", classes);
  return {};
}

std::string take_tree_column(std::istringstream& words, BoostedTrees& trees, std::string& name) {
  std::size_t count = 0;
  if (!next_number(words, count) || count > kMostLimits) return "there is no such number of limits";
  std::vector<float> limits(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!next_number(words, limits[i]) || !std::isfinite(limits[i])) return fmt::format("fewer than {} numbers", count);
    if (i > 0 && !(limits[i] > limits[i - 1])) return "limits do not rise";
  }
  std::getline(words >> std::ws, name);
  trees.limits.push_back(limits);
  return {};
}

std::string take_tree_nodes(std::istringstream& words, BoostedTrees& trees) {
  const std::size_t leaves = std::size_t{1} << trees.depth;
  std::string word;
  for (std::size_t n = 0; n + 1 < leaves; ++n) {
    trees.splits.emplace_back();
    if (!(words >> word) || !split_of(word, trees, trees.splits.back())) return "a node is none";
  }
  for (std::size_t n = 0; n < leaves; ++n) {
    trees.leaves.emplace_back();
    if (!next_number(words, trees.leaves.back())) return fmt::format("fewer than {} leaves", leaves);
  }
  return {};
}

}  // namespace ilot
