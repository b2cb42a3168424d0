// SPDX-License-Identifier: Apache-2.0
#include "tools/scan/scenes.h"

#include <gtest/gtest.h>

#include <set>

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

}  // namespace
}  // namespace ilot::scan
