// SPDX-License-Identifier: Apache-2.0
// pavements.gpkg: layer `pavements` has the areas between kerbs and what ends the pavement, layer `widths` the widths
// that were measured across them, layer `road_edges` the kerbs at the height of the road, layer `carriageways` the road
// between them. Columns: docs/outputs.md.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "engine/cloud/cloud_info.h"
#include "engine/model/street.h"

namespace ilot {

// The file is complete or absent; there are no time stamps. Throws Error when it cannot be written.
void write_pavements_gpkg(const std::filesystem::path& path, const StreetPlan& plan, double metres_per_unit,
                          const Crs& crs);

// "open", "unsure", "wall", "barrier", "step": as the column `ends_at` has it.
const char* name_of(PavementEnd end);
std::optional<PavementEnd> pavement_end_named(std::string_view name);

}  // namespace ilot
