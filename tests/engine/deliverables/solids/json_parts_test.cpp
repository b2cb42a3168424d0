// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/json_parts.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace ilot {
namespace {

TEST(JsonParts, FieldsThatAreMissingAreNull) {
  const nlohmann::json object{{"a", 1}};
  EXPECT_EQ(json_field(object, "a"), 1);
  EXPECT_TRUE(json_field(object, "b").is_null());
  EXPECT_TRUE(json_field(nlohmann::json(3), "b").is_null());
}

TEST(JsonParts, BrokenAndDeepTextsHaveAPlace) {
  EXPECT_EQ(parse_json("[1]", "x").size(), 1u);
  for (const std::string& text : {std::string("{"), std::string(100, '[') + std::string(100, ']')}) {
    try {
      parse_json(text, "file:7");
      FAIL();
    } catch (const Error& fault) {
      EXPECT_TRUE(std::string(fault.what()).starts_with("file:7: "));
    }
  }
}

TEST(JsonParts, SequencesHaveALineEach) {
  EXPECT_TRUE(is_json_sequence("{}\n{}"));
  EXPECT_FALSE(is_json_sequence("{\n}"));
  EXPECT_FALSE(is_json_sequence("{}\n"));
}

}  // namespace
}  // namespace ilot
