// SPDX-License-Identifier: Apache-2.0
// Internal to the classifier of candidates: its trees as lines of text.
#pragma once
#include <sstream>
#include <string>

#include "engine/products/streets/classes/role_trees.h"

namespace ilot {

// Writes trees as text: a line of `keyword`, their depth and the initial sums of all classes; a line "column" for each
// column with its limits and its name; and a line "tree" for each tree with its nodes as column:limit, or "-", then its
// leaves. The text is empty if there are no trees.
std::string column_trees_text(const char* keyword, const ColumnTrees& model);

// The stages of the roles, each with the keyword "stage".
std::string role_trees_text(const RoleTrees& model);

// Reads these lines one by one: the trees of classes with the keyword "classes", and the stages of roles. The functions
// return a description of the error, or an empty string.
class TreesReader {
 public:
  static bool knows(const std::string& word) {
    return word == "classes" || word == "stage" || word == "column" || word == "tree";
  }
  std::string take(const std::string& line, std::size_t classes);  // the number of classes of the model
  std::string finish(RoleTrees& roles, ColumnTrees& classes);

 private:
  std::string begin(std::istringstream& words, std::size_t classes, std::size_t columns);
  std::string take_column(std::istringstream& words);

  RoleTrees roles_;
  ColumnTrees classes_;
  ColumnTrees* open_ = nullptr;  // the trees that the next lines belong to
  std::size_t stages_ = 0, columns_ = 0;
};

}  // namespace ilot
