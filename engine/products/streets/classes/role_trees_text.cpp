// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/role_trees_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>

namespace ilot {
namespace {

constexpr std::size_t kMostDepth = 7;

// Parses the whole word as a number. Returns false where the word is not exactly one number.
template <class Number>
bool number_of(std::string_view word, Number& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

template <class Number>
bool next_number(std::istringstream& words, Number& value) {
  std::string word;
  return words >> word && number_of(word, value);
}

// Parses "-", or a column and one of its limits in this stage.
bool split_of(const std::string& word, const ColumnTrees& stage, TreeSplit& split) {
  split = {0, kNoSplit};
  if (word == "-") return true;
  const std::size_t colon = word.find(':');
  return colon != std::string::npos && number_of(std::string_view(word).substr(0, colon), split.column) &&
         number_of(std::string_view(word).substr(colon + 1), split.bin) && split.column < stage.columns.size() &&
         split.bin < stage.trees.limits[split.column].size();
}

}  // namespace

std::string column_trees_text(const char* keyword, const ColumnTrees& model) {
  if (model.empty()) return {};
  const BoostedTrees& trees = model.trees;
  std::string text = fmt::format("{} {} {}\n", keyword, trees.depth, fmt::join(trees.first, " "));
  for (std::size_t c = 0; c < model.columns.size(); ++c) {
    text += fmt::format("column {}", trees.limits[c].size());
    for (const float limit : trees.limits[c]) text += fmt::format(" {:.9g}", limit);
    text += " " + role_column_name(model.columns[c]) + "\n";
  }
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

std::string role_trees_text(const RoleTrees& model) {
  std::string text;
  for (const ColumnTrees& stage : model.stages) text += column_trees_text("stage", stage);
  return text;
}

std::string TreesReader::take(const std::string& line, std::size_t classes) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  if (word == "classes") {
    if (!classes_.empty() || open_ == &classes_) return "there are two lists of trees of the classes";
    open_ = &classes_;
    return begin(words, classes, kCandidateFeatures);
  }
  if (word == "stage") {
    if (++stages_ > kRoleStages) return "there are too many stages";
    open_ = &roles_.stages[stages_ - 1];
    return begin(words, kCandidateKinds, stages_ == 1 ? kCandidateFeatures : kRoleColumns);
  }
  if (open_ == nullptr) return "stands before any stage";
  return word == "column" ? take_column(words) : take_tree(words);
}

std::string TreesReader::begin(std::istringstream& words, std::size_t classes, std::size_t columns) {
  columns_ = columns;
  BoostedTrees& trees = open_->trees;
  trees.classes = classes;
  trees.first.resize(classes);
  if (!next_number(words, trees.depth) || trees.depth == 0 || trees.depth > kMostDepth) return "there is no such depth";
  for (std::int32_t& first : trees.first)
    if (!next_number(words, first)) return fmt::format("fewer than {} numbers", classes);
  return {};
}

std::string TreesReader::take_column(std::istringstream& words) {
  std::size_t count = 0;
  if (!next_number(words, count) || count > 255) return "there is no such number of limits";
  std::vector<float> limits(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!next_number(words, limits[i]) || !std::isfinite(limits[i])) return fmt::format("fewer than {} numbers", count);
    if (i > 0 && !(limits[i] > limits[i - 1])) return "limits do not rise";
  }
  std::string name;
  std::getline(words >> std::ws, name);
  for (std::size_t c = 0; c < columns_; ++c) {
    if (role_column_name(c) != name) continue;
    open_->columns.push_back(c);
    open_->trees.limits.push_back(limits);
    return {};
  }
  return "there is no column '" + name + "'";
}

std::string TreesReader::take_tree(std::istringstream& words) {
  BoostedTrees& trees = open_->trees;
  const std::size_t leaves = std::size_t{1} << trees.depth;
  std::string word;
  for (std::size_t n = 0; n + 1 < leaves; ++n) {
    trees.splits.emplace_back();
    if (!(words >> word) || !split_of(word, *open_, trees.splits.back())) return "a node is none";
  }
  for (std::size_t n = 0; n < leaves; ++n) {
    trees.leaves.emplace_back();
    if (!next_number(words, trees.leaves.back())) return fmt::format("fewer than {} leaves", leaves);
  }
  return {};
}

std::string TreesReader::finish(RoleTrees& roles, ColumnTrees& classes) {
  if (stages_ != 0 && stages_ != kRoleStages) return "ends before its last stage";
  for (std::size_t s = 0; s < stages_; ++s) {
    const BoostedTrees& trees = roles_.stages[s].trees;
    if (trees.trees() == 0 || trees.trees() % kCandidateKinds != 0) return "ends before its last tree";
  }
  if (classes_.trees.classes != 0 && (classes_.empty() || classes_.trees.trees() % classes_.trees.classes != 0))
    return "ends before the last tree of the classes";
  roles = std::move(roles_);
  classes = std::move(classes_);
  return {};
}

}  // namespace ilot
