// SPDX-License-Identifier: Apache-2.0
// Internal to the models of streets: boosted trees as lines of text.
#pragma once
#include <charconv>
#include <sstream>
#include <string>
#include <string_view>

#include "kernels/classifiers/boosted_trees.h"

namespace ilot {

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

// The words after the name of the stage: the depth and the initial sums of all classes.
std::string tree_start_text(const BoostedTrees& trees);
// A line "column" with the limits of a column and its name.
std::string tree_column_text(const BoostedTrees& trees, std::size_t column, const std::string& name);
// A line "tree" for each tree, with its nodes as column:limit, or "-", then its leaves.
std::string tree_nodes_text(const BoostedTrees& trees);

// These read the words after the first one of such a line. They return a description of the error, or an empty string.
std::string take_tree_start(std::istringstream& words, std::size_t classes, BoostedTrees& trees);
std::string take_tree_column(std::istringstream& words, BoostedTrees& trees, std::string& name);
std::string take_tree_nodes(std::istringstream& words, BoostedTrees& trees);

}  // namespace ilot
