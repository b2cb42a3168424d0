// SPDX-License-Identifier: Apache-2.0
// trees.gpkg: layer `trees` has the positions of trees on the ground, layer `crowns` has circles with the areas of
// their crowns. Columns: docs/outputs.md.
#pragma once
#include <filesystem>

#include "engine/cloud/cloud_info.h"
#include "engine/model/street.h"

namespace ilot {

// The file is complete or absent; there are no time stamps. Throws Error when it cannot be written.
void write_trees_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs);

}  // namespace ilot
