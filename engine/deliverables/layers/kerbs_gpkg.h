// SPDX-License-Identifier: Apache-2.0
// kerbs.gpkg: layer `kerbs` has the upper edges of kerbs as lines, layer `heights` has the height of the step at each
// of their vertices. Columns: docs/outputs.md.
#pragma once
#include <filesystem>

#include "engine/cloud/cloud_info.h"
#include "engine/model/street.h"

namespace ilot {

// The file is complete or absent; there are no time stamps. Throws Error when it cannot be written.
void write_kerbs_gpkg(const std::filesystem::path& path, const StreetPlan& plan, const Crs& crs);

}  // namespace ilot
