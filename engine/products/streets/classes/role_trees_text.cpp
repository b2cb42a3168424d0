// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/role_trees_text.h"

#include <fmt/format.h>

#include "engine/products/streets/classes/tree_text.h"

namespace ilot {
std::string column_trees_text(const char* keyword, const ColumnTrees& model) {
  if (model.empty()) return {};
  const BoostedTrees& trees = model.trees;
  std::string text = std::string(keyword) + " " + tree_start_text(trees);
  for (std::size_t c = 0; c < model.columns.size(); ++c)
    text += tree_column_text(trees, c, role_column_name(model.columns[c]));
  text += tree_nodes_text(trees);
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
  return word == "column" ? take_column(words) : take_tree_nodes(words, open_->trees);
}

std::string TreesReader::begin(std::istringstream& words, std::size_t classes, std::size_t columns) {
  columns_ = columns;
  return take_tree_start(words, classes, open_->trees);
}

std::string TreesReader::take_column(std::istringstream& words) {
  std::string name;
  if (std::string error = take_tree_column(words, open_->trees, name); !error.empty()) return error;
  for (std::size_t c = 0; c < columns_; ++c) {
    if (role_column_name(c) != name) continue;
    open_->columns.push_back(c);
    return {};
  }
  return "there is no column '" + name + "'";
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
