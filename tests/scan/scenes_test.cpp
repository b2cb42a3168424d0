// SPDX-License-Identifier: Apache-2.0
#include "scan/scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "engine/error.h"

namespace ilot::scan {
namespace {

TEST(Scenes, EachHasANameOfItsOwnAndOptionsWithinTheirRange) {
  std::set<std::string_view> names;
  for (const Scene& scene : scenes()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_EQ(&find_scene(scene.name), &scene);
    std::set<std::string_view> keys;
    for (const SceneOption& option : scene.options) {
      EXPECT_TRUE(keys.insert(option.key).second) << scene.name << option.key;
      EXPECT_TRUE(option.key.starts_with("scene.")) << option.key;
      EXPECT_LE(option.low, option.standard) << option.key;
      EXPECT_LE(option.standard, option.high) << option.key;
      EXPECT_FALSE(option.unit.empty()) << option.key;
      EXPECT_NE(list_scenes().find(option.key), std::string::npos);
    }
  }
}

TEST(Scenes, AnUnknownNameIsRefused) {
  try {
    find_scene("village");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
  }
}

// Everything from the heading of the options on is generated; what stands before is written by hand.
TEST(Scenes, DocumentationIsUpToDate) {
  const std::string path = std::string(ILOT_SOURCE_DIR) + "/docs/scenes.md";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string whole = text.str();
  const std::size_t at = whole.find("## Options\n");
  ASSERT_NE(at, std::string::npos);
  if (std::getenv("ILOT_UPDATE_GOLDEN") != nullptr)
    std::ofstream(path) << whole.substr(0, at) << scenes_markdown();
  else
    EXPECT_EQ(whole.substr(at), scenes_markdown()) << "run this test with ILOT_UPDATE_GOLDEN=1 and review " << path;
  for (const Scene& scene : scenes())
    EXPECT_NE(whole.substr(0, at).find("| `" + std::string(scene.name) + "` |"), std::string::npos) << scene.name;
}

}  // namespace
}  // namespace ilot::scan
