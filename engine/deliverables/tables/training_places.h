// SPDX-License-Identifier: Apache-2.0
// Where things on streets stand and what they are, to learn from.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/model/point_label.h"
#include "kernels/core/types.h"

namespace ilot {

struct TrainingPlace {
  Vec3 at;  // in the CRS of the clouds; the middle of an area
  PointLabel label = PointLabel::none;
};

// From the first layer with features of any vector file that GDAL reads, points or polygons with the text attribute
// `class` (any case): car, lamppost, pedestrian, other, vegetation, or none for what is no thing; or from the objects
// of a truth file (*.truth.json). Throws Error, of ExitCode::usage where the file is at fault.
std::vector<TrainingPlace> read_training_places(const std::filesystem::path& path, const Crs& crs);

}  // namespace ilot
