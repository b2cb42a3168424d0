// SPDX-License-Identifier: Apache-2.0
// Reader of roofs.city.jsonl with all levels of detail, surfaces and attributes. model_file.h reads models from other
// software.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/model/building.h"

namespace ilot {

// An Error names the file and the line.
std::vector<BuildingModel> read_roofs_sequence(const std::filesystem::path& path);

}  // namespace ilot
