// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/structure_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "engine/error.h"
#include "engine/products/streets/classes/tree_text.h"

namespace ilot {
namespace {

constexpr const char* kHead = "ilot structures 1";

std::string take_line(const std::string& line, StructureModel& model) {
  if (line.rfind("# ", 0) == 0) {
    model.recipe += line.substr(2) + "\n";
    return {};
  }
  std::istringstream words(line);
  std::string word, name;
  words >> word;
  const bool started = model.trees.classes != 0;
  if (word == "trees" && started) return "there are two lists of trees";
  if (word == "trees") return take_tree_start(words, kStandingKinds, model.trees);
  if (!started) return "stands before the trees";
  if (word == "tree") return take_tree_nodes(words, model.trees);
  if (word != "column") return "there is no '" + word + "'";
  const std::size_t column = model.trees.limits.size();
  if (std::string error = take_tree_column(words, model.trees, name); !error.empty()) return error;
  if (column >= standing_features() || standing_feature_name(column) != name)
    return "'" + name + "' is not the next column";
  return {};
}

}  // namespace

std::vector<StandingKind> standing_kinds(const StructureModel& model, const StandingRows& rows) {
  std::vector<std::int32_t> scores(rows.cells.size() * kStandingKinds);
  tree_scores(model.trees, rows.rows, scores);
  std::vector<StandingKind> kinds;
  for (auto s = scores.begin(); s != scores.end(); s += kStandingKinds)
    kinds.push_back(static_cast<StandingKind>(std::max_element(s, s + kStandingKinds) - s));
  return kinds;
}

std::string structure_model_text(const StructureModel& model) {
  std::string text = std::string(kHead) + "\n", line;
  for (std::istringstream lines(model.recipe); std::getline(lines, line);) text += "# " + line + "\n";
  text += "trees " + tree_start_text(model.trees);
  for (std::size_t c = 0; c < standing_features(); ++c)
    text += tree_column_text(model.trees, c, standing_feature_name(c));
  return text + tree_nodes_text(model.trees);
}

StructureModel parse_structure_model(std::string_view text, const std::string& name) {
  StructureModel model;
  std::istringstream lines{std::string(text)};
  std::string line;
  std::size_t number = 1;
  const auto check = [&](const std::string& error) {
    if (!error.empty()) throw Error(fmt::format("{}:{}: {}", name, number, error), ExitCode::usage);
  };
  std::getline(lines, line);
  check(line == kHead ? "" : "is no model of structures");
  for (++number; std::getline(lines, line); ++number) check(take_line(line, model));
  const BoostedTrees& trees = model.trees;
  if (trees.limits.size() != standing_features() || trees.trees() == 0 || trees.trees() % kStandingKinds != 0)
    check("ends before its last tree");
  return model;
}

}  // namespace ilot
