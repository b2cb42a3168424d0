// SPDX-License-Identifier: Apache-2.0
// Readers of the GeoPackages that a run writes (planes_gpkg.h, streets_gpkg.h).
#pragma once
#include <filesystem>
#include <vector>

#include "engine/model/outline.h"
#include "engine/model/street.h"

namespace ilot {

// Returns one outline for each feature, in the file's order. An Error names the file.
std::vector<Outline> read_planes_gpkg(const std::filesystem::path& path);

// Return the objects of objects.gpkg, without the heights of their middles, and the parts of blocks.gpkg. An Error
// names the file.
std::vector<StreetObject> read_objects_gpkg(const std::filesystem::path& path);
void read_blocks_gpkg(const std::filesystem::path& path, StreetPlan& plan);

}  // namespace ilot
