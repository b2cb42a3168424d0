// SPDX-License-Identifier: Apache-2.0
// Reader of roofs.city.jsonl with all levels of detail, surfaces and attributes. model_file.h reads models from other
// software.
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/model/building.h"

namespace ilot {

// Reads one building after the other, so that a file of any length fits. An Error names the file and the line.
void for_each_roof(const std::filesystem::path& path, const std::function<void(const BuildingModel&)>& use);

// The same, all at once.
std::vector<BuildingModel> read_roofs_sequence(const std::filesystem::path& path);

}  // namespace ilot
