// SPDX-License-Identifier: Apache-2.0
// The scenes that can be scanned. The command line and the documentation are both made from this one table.
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
  std::optional<std::uint64_t> points;  // number of points; the scene states how near it comes
  std::filesystem::path output;         // the cloud; its truth goes to truth_path(output)
  std::function<void(std::uint64_t)> written = [](std::uint64_t) {};  // called as points are written
};

// The counts of a scan, to be read by people. "points" comes first, then what the scene counts.
using ScanCounts = std::vector<std::pair<std::string, std::uint64_t>>;

struct Scene {
  std::string_view name, help;
  std::string_view points;  // how the scene meets --points
  std::span<const SceneOption> options;
  // Writes the cloud and its truth. Each file is written whole or not at all. The work runs on the threads of the
  // calling arena, and the bytes do not depend on the number of threads. Throws Error.
  ScanCounts (*scan)(const ScanRequest& request);
  std::span<const std::string_view> groups = {};  // of distributions.csv that it draws from; none = nothing is drawn
};

// Returns the scenes in the order of the documentation.
std::span<const Scene> scenes();

// Throws Error (usage) if there is no scene with this name.
const Scene& find_scene(std::string_view name);

// Returns a list of the scenes and their options, to be read by people.
std::string list_scenes();

// Returns the same list as tables for docs/scenes.md.
std::string scenes_markdown();

}  // namespace ilot::scan
