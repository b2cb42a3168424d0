// SPDX-License-Identifier: Apache-2.0
// The scenes that can be scanned: one table, from which the command line and the documentation are made.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scan/scene_options.h"

namespace ilot::scan {

struct ScanRequest {
  std::string_view scene;
  SceneValues values;  // of the scene's options
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> points;                                // how many, or as near as the scene says
  std::filesystem::path output;                                       // the cloud; its truth goes to truth_path(output)
  std::function<void(std::uint64_t)> written = [](std::uint64_t) {};  // hears of points as they are written
};

// What a scan gave, for people: "points" first, then whatever the scene counts.
using ScanCounts = std::vector<std::pair<std::string, std::uint64_t>>;

struct Scene {
  std::string_view name, help;
  std::string_view points;  // how --points is met
  std::span<const SceneOption> options;
  // Writes the cloud and its truth, each whole or not at all, on the threads of the calling arena. The bytes do not
  // depend on their number. Throws Error.
  ScanCounts (*scan)(const ScanRequest& request);
};

// In the order of the documentation.
std::span<const Scene> scenes();

// Throws Error (usage).
const Scene& find_scene(std::string_view name);

// Scenes and their options, for people.
std::string list_scenes();

// The same as tables for docs/scenes.md.
std::string scenes_markdown();

}  // namespace ilot::scan
