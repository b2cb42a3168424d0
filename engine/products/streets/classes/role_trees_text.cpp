// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/role_trees_text.h"

#include <fmt/format.h>

#include "engine/products/streets/classes/tree_text.h"

namespace ilot {

std::string role_trees_text(const RoleTrees& model) {
  std::string text;
  if (model.empty()) return text;
  for (const RoleStage& stage : model.stages) {
    const BoostedTrees& trees = stage.trees;
    text += "stage " + tree_start_text(trees);
    for (std::size_t c = 0; c < stage.columns.size(); ++c)
      text += tree_column_text(trees, c, role_column_name(stage.columns[c]));
    text += tree_nodes_text(trees);
  }
  return text;
}

std::string RoleTreesReader::take(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  if (word == "stage") return take_stage(words);
  if (stages_ == 0) return "stands before any stage";
  return word == "column" ? take_column(words) : take_tree_nodes(words, stage().trees);
}

std::string RoleTreesReader::take_stage(std::istringstream& words) {
  if (++stages_ > kRoleStages) return "there are too many stages";
  return take_tree_start(words, kCandidateKinds, stage().trees);
}

std::string RoleTreesReader::take_column(std::istringstream& words) {
  std::string name;
  if (std::string error = take_tree_column(words, stage().trees, name); !error.empty()) return error;
  for (std::size_t c = 0; c < (stages_ == 1 ? kCandidateFeatures : kRoleColumns); ++c) {
    if (role_column_name(c) != name) continue;
    stage().columns.push_back(c);
    return {};
  }
  return "there is no column '" + name + "'";
}

std::string RoleTreesReader::finish(RoleTrees& model) {
  if (stages_ != 0 && stages_ != kRoleStages) return "ends before its last stage";
  for (std::size_t s = 0; s < stages_; ++s) {
    const BoostedTrees& trees = model_.stages[s].trees;
    if (trees.trees() == 0 || trees.trees() % kCandidateKinds != 0) return "ends before its last tree";
  }
  model = std::move(model_);
  return {};
}

}  // namespace ilot
