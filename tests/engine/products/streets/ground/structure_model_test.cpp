// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/structure_model.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace ilot {
namespace {

TEST(StructureModel, TheTextIsTheModel) {
  const StructureModel& model = default_structure_model();
  EXPECT_EQ(model.trees.classes, kStandingKinds);
  EXPECT_FALSE(model.recipe.empty());
  const std::string text = structure_model_text(model);
  EXPECT_EQ(structure_model_text(parse_structure_model(text, "m")), text);
}

TEST(StructureModel, BrokenTextsSayWhere) {
  const std::string text = structure_model_text(default_structure_model());
  const auto error_of = [](const std::string& t) -> std::string {
    try {
      parse_structure_model(t, "m");
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(error_of("ilot objects 3\n"), "m:1: is no model of structures");
  EXPECT_EQ(error_of(text.substr(0, text.find("\ncolumn") + 1)).substr(0, 2), "m:");
  std::string other = text;
  other.replace(other.find(" top\n"), 5, " tip\n");
  EXPECT_NE(error_of(other).find("'tip' is not the next column"), std::string::npos);
  std::string node = text;
  node.replace(node.find("\ntree ") + 6, 1, "x");
  EXPECT_NE(error_of(node).find("a node is none"), std::string::npos);
}

}  // namespace
}  // namespace ilot
