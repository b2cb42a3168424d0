// SPDX-License-Identifier: Apache-2.0
#include "engine/settings/settings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "engine/error.h"
#include "engine/settings/config.h"
#include "engine/settings/parameters.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

std::string settings_fault(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
  return "no fault";
}

std::string load_fault(const std::string& text) {
  Settings settings;
  const std::uint64_t before = settings_hash(settings);
  const std::string fault = settings_fault([&] { load_config_text(settings, text, "ilot.toml"); });
  EXPECT_EQ(settings_hash(settings), before) << "a refused file must change nothing";
  return fault;
}

std::string set_fault(const std::string& assignment) {
  Settings settings;
  return settings_fault([&] { apply_assignment(settings, assignment); });
}

TEST(Config, ReadsEveryKindOfValue) {
  Settings s;
  load_config_text(
      s,
      "seed = 9\n[planes]\nepsilon = 0.02\nmin_points = \"auto\"\njoin_angle = 5\n[normals]\nwrite = true\n"
      "[classes]\nbuilding = [6, 67]\nnoise = []\n",
      "t");
  EXPECT_EQ(s.seed, 9u);
  EXPECT_EQ(s.planes.epsilon, 0.02);
  EXPECT_FALSE(s.planes.min_points);
  EXPECT_EQ(s.planes.join_angle, 5.0);
  EXPECT_TRUE(s.normals.write);
  EXPECT_EQ(s.classes.building, (std::vector<int>{6, 67}));
  EXPECT_TRUE(s.classes.noise.empty());
  EXPECT_EQ(s.classes.ground, std::vector<int>{2});
}

TEST(Config, DottedKeysEqualSections) {
  Settings a, b;
  load_config_text(a, "planes.epsilon = 0.1", "t");
  load_config_text(b, "[planes]\nepsilon = 0.1", "t");
  EXPECT_EQ(settings_hash(a), settings_hash(b));
}

TEST(Config, NamesThePlaceAndTheNearestKey) {
  EXPECT_EQ(load_fault("[planes]\nepsilom = 0.02\n"),
            "ilot.toml:2:1: unknown setting 'planes.epsilom'; did you mean 'planes.epsilon'?");
  EXPECT_EQ(load_fault("[plane]\nepsilon = 0.02\n"),
            "ilot.toml:1:2: unknown setting 'plane.epsilon'; did you mean 'planes.epsilon'?");
  EXPECT_EQ(load_fault("sede = 1\n"), "ilot.toml:1:1: unknown setting 'sede'; did you mean 'seed'?");
  EXPECT_EQ(load_fault("planes = 3\n"), "ilot.toml:1:1: 'planes' is a section: write [planes]");
}

TEST(Config, NamesTheRange) {
  EXPECT_EQ(load_fault("[planes]\nepsilon = 20\n"),
            "ilot.toml:2:11: planes.epsilon = 20 is out of range: 0.0001 to 10 m");
  EXPECT_EQ(load_fault("[classes]\nnoise = [7, 300]\n"),
            "ilot.toml:2:9: classes.noise = [7, 300] is out of range: 0 to 255");
  EXPECT_EQ(load_fault("[planes]\nepsilon = nan\n"),
            "ilot.toml:2:11: planes.epsilon = nan is out of range: 0.0001 to 10 m");
}

TEST(Config, OnlyCommentsGoBeyondAscii) {
  EXPECT_EQ(load_fault("seed = 1\n\xC6\x93 = 2\n"),
            "ilot.toml:2:1: a character beyond ASCII; only comments may contain them");
  EXPECT_EQ(load_fault("seed = 1 \"#\" \xC6\x93\n"),
            "ilot.toml:1:1: a character beyond ASCII; only comments may contain them");
  Settings s;
  load_config_text(s, "seed = 3  # \xC6\x93 c'est le troisi\xC3\xA8me\n", "t");
  EXPECT_EQ(s.seed, 3u);
}

TEST(Config, NamesTheType) {
  EXPECT_EQ(load_fault("[planes]\nepsilon = \"wide\"\n"),
            "ilot.toml:2:11: planes.epsilon must be a number (m) or \"auto\", not \"wide\"");
  EXPECT_EQ(load_fault("[normals]\nneighbours = 8.5\n"),
            "ilot.toml:2:14: normals.neighbours must be a whole number (points), not 8.5");
  EXPECT_EQ(load_fault("[normals]\nwrite = 1\n"), "ilot.toml:2:9: normals.write must be true or false, not 1");
  EXPECT_EQ(load_fault("[normals]\nneighbours = \"auto\"\n"),
            "ilot.toml:2:14: normals.neighbours cannot be \"auto\": it must be a whole number (points)");
  EXPECT_EQ(load_fault("[classes]\nnoise = [7, \"x\"]\n"),
            "ilot.toml:2:9: classes.noise must be a list of whole numbers, not a list of other values");
  EXPECT_EQ(load_fault("seed = 1979-05-27\n"), "ilot.toml:1:8: seed must be a whole number, not a date or time");
  EXPECT_EQ(load_fault("[seed]\nx = 1\n"), "ilot.toml:1:2: seed must be a whole number, not a table");
}

TEST(Config, NamesTheBrokenLine) {
  EXPECT_EQ(load_fault("seed = 1\n[planes\n").substr(0, 12), "ilot.toml:2:");
  EXPECT_EQ(load_fault("seed = 1\nseed = 2\n").substr(0, 12), "ilot.toml:2:");
}

TEST(Config, MissingFile) {
  Settings s;
  EXPECT_EQ(settings_fault([&] { load_config(s, "/nonexistent/ilot.toml"); }),
            "/nonexistent/ilot.toml: cannot read the configuration: No such file or directory");
}

// A file with any byte changed or cut anywhere is refused, with the name of the file in front and nothing changed, or
// understood: then what is printed of them says the same.
TEST(Config, AnyByteMayBeAnything) {
  const std::string good =
      "seed = 31\n[planes]\nepsilon = 0.125\nmin_points = 40\n[classes]\nnoise = [7, 18]\n[normals]\nwrite = true\n";
  Rng rng(5);
  int understood = 0, refused = 0;
  for (int round = 0; round < 1000; ++round) {
    std::string text = good;
    text[rng.below(text.size())] = static_cast<char>(rng.below(4) == 0 ? rng.below(256) : '0' + rng.below(10));
    if (rng.below(8) == 0) text.resize(rng.below(text.size()));
    Settings s;
    try {
      load_config_text(s, text, "t");
    } catch (const Error& error) {
      ASSERT_EQ(std::string(error.what()).rfind("t:", 0), 0u) << error.what();
      ASSERT_EQ(settings_hash(s), settings_hash(Settings{})) << text;
      ++refused;
      continue;
    }
    Settings again;
    load_config_text(again, print_config(s), "printed");
    ASSERT_EQ(settings_hash(again), settings_hash(s)) << text;
    ++understood;
  }
  EXPECT_GT(understood, 50);
  EXPECT_GT(refused, 50);
}

TEST(Assignment, OverridesTheFile) {
  Settings s;
  load_config_text(s, "planes.epsilon = 0.1\nplanes.min_points = 40", "t");
  apply_assignment(s, "planes.epsilon=0.02");
  apply_assignment(s, "planes.min_points=auto");
  apply_assignment(s, "classes.building=[6, 67]");
  EXPECT_EQ(s.planes.epsilon, 0.02);
  EXPECT_FALSE(s.planes.min_points);
  EXPECT_EQ(s.classes.building.size(), 2u);
}

TEST(Assignment, NamesTheFault) {
  EXPECT_EQ(set_fault("planes.epsilon"), "--set planes.epsilon: expected KEY=VALUE, as in planes.epsilon=0.02");
  EXPECT_EQ(set_fault("plane.epsilon=1"),
            "--set plane.epsilon=1: unknown setting 'plane.epsilon'; did you mean 'planes.epsilon'?");
  EXPECT_EQ(set_fault("planes.epsilon=-1"),
            "--set planes.epsilon=-1: planes.epsilon = -1 is out of range: 0.0001 to 10 m");
  EXPECT_EQ(set_fault("planes.epsilon=wide"),
            "--set planes.epsilon=wide: planes.epsilon must be a number (m) or \"auto\", not \"wide\"");
  EXPECT_EQ(set_fault("seed=1\nseed = 2").substr(0, 6), "--set ");
  EXPECT_EQ(set_fault("seed=").substr(0, 11), "--set seed=");
  EXPECT_EQ(set_fault("seed=99999999999999999999").substr(0, 11), "--set seed=");
}

TEST(PrintConfig, LoadsBackToTheSameSettings) {
  Settings s;
  s.seed = 77;
  s.planes.epsilon = 0.1 + 0.2;
  s.planes.min_points = 12;
  s.normals.write = true;
  s.classes.noise = {};
  for (const Settings& settings : {Settings{}, s}) {
    Settings back;
    back.seed = 5;
    load_config_text(back, print_config(settings), "t");
    EXPECT_TRUE(differing_keys(settings, back).empty());
    EXPECT_EQ(settings_json(settings), settings_json(back));
  }
  EXPECT_EQ(differing_keys(Settings{}, s), (std::vector<std::string>{"seed", "normals.write", "planes.epsilon",
                                                                     "planes.min_points", "classes.noise"}));
}

TEST(SettingsHash, ChangesWithEveryParameter) {
  const std::uint64_t base = settings_hash(Settings{});
  for (const Parameter& p : parameters()) {
    Settings changed;
    Value value = std::int64_t{static_cast<std::int64_t>(p.range.max)};
    if (p.kind == ParameterKind::boolean) value = p.get(Settings{}) != Value(true);
    if (p.kind == ParameterKind::number) value = p.range.max;
    if (p.kind == ParameterKind::integers) value = std::vector<std::int64_t>{1};
    if (p.kind == ParameterKind::numbers) value = std::vector<double>{p.range.max, 0.5};
    if (p.kind == ParameterKind::choice) value = std::string(p.choices.back());
    ASSERT_FALSE(check_value(p, value)) << p.key;
    p.set(changed, value);
    EXPECT_EQ(p.get(changed), value) << p.key;
    EXPECT_NE(settings_hash(changed), base) << p.key;
  }
}

TEST(Parameters, DefaultsAreInRangeAndDescribed) {
  const Settings standard;
  for (const Parameter& p : parameters()) {
    EXPECT_FALSE(check_value(p, p.get(standard))) << p.key;
    EXPECT_FALSE(p.help.empty()) << p.key;
    EXPECT_EQ(p.help.find('|'), std::string::npos) << p.key;
    EXPECT_EQ(find_parameter(p.key), &p) << "two parameters of one name";
  }
}

TEST(Parameters, AdvancedOnesAreTheLastOfTheirSection) {
  std::string section;
  bool advanced = false;
  std::size_t count = 0;
  for (const Parameter& p : parameters()) {
    const std::string own = p.key.substr(0, p.key.find('.'));
    EXPECT_TRUE(p.advanced || own != section || !advanced) << p.key;
    section = own;
    advanced = p.advanced;
    count += advanced;
  }
  EXPECT_GT(count, 0u);
  Settings settings;
  apply_assignment(settings, "facades.door_height=2.1");
  EXPECT_EQ(settings.facades.advanced.door_height, 2.1);
  EXPECT_NE(print_config(settings).find("\n# Advanced: "), std::string::npos);
}

TEST(Parameters, DocumentationIsUpToDate) {
  const std::string path = std::string(ILOT_SOURCE_DIR) + "/docs/parameters.md";
  if (std::getenv("ILOT_UPDATE_GOLDEN") != nullptr) std::ofstream(path) << parameters_markdown();
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), parameters_markdown())
      << "run this test with ILOT_UPDATE_GOLDEN=1 and review docs/parameters.md";
}

}  // namespace
}  // namespace ilot
