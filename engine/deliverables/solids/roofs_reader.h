// SPDX-License-Identifier: Apache-2.0
// The way back from roofs.city.jsonl, with all levels of detail, surfaces and attributes. Models of anybody else are
// read by model_file.h.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/model/building.h"

namespace ilot {

// Error names the file and the line.
std::vector<BuildingModel> read_roofs_sequence(const std::filesystem::path& path);

}  // namespace ilot
