// SPDX-License-Identifier: Apache-2.0
// Inside of the things' machine: its trees as lines of its text.
#pragma once
#include <sstream>
#include <string>

#include "engine/products/streets/classes/role_trees.h"

namespace ilot {

// For each stage a line "stage", its depth and where the sums of all natures begin; a line "column" with the limits and
// the name of each; and a line "tree" for each tree: its nodes as column:limit, or "-", then its leaves. Nothing for no
// trees.
std::string role_trees_text(const RoleTrees& model);

// Reads these lines one by one. What is wrong with them, or nothing.
class RoleTreesReader {
 public:
  std::string take(const std::string& line);
  std::string finish(RoleTrees& model);

 private:
  std::string take_stage(std::istringstream& words);
  std::string take_column(std::istringstream& words);
  std::string take_tree(std::istringstream& words);
  RoleStage& stage() { return model_.stages[stages_ - 1]; }

  RoleTrees model_;
  std::size_t stages_ = 0;
};

}  // namespace ilot
