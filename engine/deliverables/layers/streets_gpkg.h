// SPDX-License-Identifier: Apache-2.0
// objects.gpkg: layer `objects` has the base points of objects on the ground, layer `extents` has the rectangles around
// them. blocks.gpkg: layers `blocks` and `gaps` have the facades of city blocks and the streets between them as lines.
// Columns: docs/outputs.md.
#pragma once
#include <filesystem>

#include "engine/cloud/cloud_info.h"
#include "engine/model/street.h"

namespace ilot {

// Each file is complete or absent; there are no time stamps. Throws Error when it cannot be written.
void write_objects_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs);
void write_blocks_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs);

}  // namespace ilot
