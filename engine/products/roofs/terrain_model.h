// SPDX-License-Identifier: Apache-2.0
// The terrain model of a run (DTM): heights of the ground as a raster.
#pragma once
#include <filesystem>
#include <string>

#include "engine/cloud/cloud_info.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

struct TerrainModel {
  double pixel_m = 0;     // 0: there is no point of the ground, and no file
  double density_m2 = 0;  // median points of the ground per square metre
};

// Writes folder/dtm.tif: the mean height of the points of the ground of each pixel, and between them heights from those
// around (ground_gaps.h) up to 50 m away; no data beyond. folder/dtm_points.tif has the number of points of each pixel:
// 0 where the height is not measured. The pixels have about four points where there is ground. Needs the column "role".
TerrainModel write_terrain_model(const Store& store, const std::filesystem::path& folder, const Crs& crs,
                                 const PassContext& context);

}  // namespace ilot
