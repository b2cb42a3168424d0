// SPDX-License-Identifier: Apache-2.0
// The way back from the GeoPackages that a run writes (planes_gpkg.h, streets_gpkg.h).
#pragma once
#include <filesystem>
#include <vector>

#include "engine/model/outline.h"
#include "engine/model/street.h"

namespace ilot {

// One outline a feature, in the file's order. Error names the file.
std::vector<Outline> read_planes_gpkg(const std::filesystem::path& path);

// The objects of objects.gpkg, without their middles' heights, and the parts of blocks.gpkg. Error names the file.
std::vector<StreetObject> read_objects_gpkg(const std::filesystem::path& path);
void read_blocks_gpkg(const std::filesystem::path& path, StreetPlan& plan);

}  // namespace ilot
