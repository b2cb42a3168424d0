// SPDX-License-Identifier: Apache-2.0
// Readers of the GeoPackages that a run writes (planes_gpkg.h, streets_gpkg.h, trees_gpkg.h,
// kerbs_gpkg.h).
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "engine/model/outline.h"
#include "engine/model/street.h"

namespace ilot {

// Calls use() for each feature, in the file's order, with its outline and the area of that. An Error names the file.
void for_each_plane_outline(const std::filesystem::path& path,
                            const std::function<void(const Outline&, double area_m2)>& use);

// The same, all at once.
std::vector<Outline> read_planes_gpkg(const std::filesystem::path& path);

// Return the objects of objects.gpkg, without the heights of their middles, and the parts of blocks.gpkg. An Error
// names the file.
std::vector<StreetKerb> read_kerbs_gpkg(const std::filesystem::path& path);
std::vector<PavementWidth> read_pavement_widths(const std::filesystem::path& path);  // of pavements.gpkg
std::vector<Pavement> read_pavements_gpkg(const std::filesystem::path& path);
std::vector<Carriageway> read_carriageways(const std::filesystem::path& path);  // of pavements.gpkg; may have none
std::vector<StreetTree> read_trees_gpkg(const std::filesystem::path& path);
std::vector<StreetObject> read_objects_gpkg(const std::filesystem::path& path);
void read_blocks_gpkg(const std::filesystem::path& path, StreetPlan& plan);

}  // namespace ilot
