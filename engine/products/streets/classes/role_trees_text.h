// SPDX-License-Identifier: Apache-2.0
// Internal to the classifier of candidates: its trees as lines of text.
#pragma once
#include <sstream>
#include <string>

#include "engine/products/streets/classes/role_trees.h"

namespace ilot {

// Writes the trees as text. For each stage there is a line "stage" with its depth and the initial sums of all kinds; a
// line "column" for each column with its limits and its name; and a line "tree" for each tree with its nodes as
// column:limit, or "-", then its leaves. The text is empty if there are no trees.
std::string role_trees_text(const RoleTrees& model);

// Reads these lines one by one. The functions return a description of the error, or an empty string.
class RoleTreesReader {
 public:
  std::string take(const std::string& line);
  std::string finish(RoleTrees& model);

 private:
  std::string take_stage(std::istringstream& words);
  std::string take_column(std::istringstream& words);
  RoleStage& stage() { return model_.stages[stages_ - 1]; }

  RoleTrees model_;
  std::size_t stages_ = 0;
};

}  // namespace ilot
