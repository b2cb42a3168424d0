// SPDX-License-Identifier: Apache-2.0
// Places and classes of street objects, from which the classifier is trained.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/model/point_label.h"
#include "kernels/core/types.h"

namespace ilot {

struct TrainingPlace {
  Vec3 at;  // in the CRS of the clouds; for an area, its middle
  PointLabel label = PointLabel::none;
};

// Reads the first layer with features of any vector file that GDAL reads. Its points or polygons have the text
// attribute `class` (in any case): a class of street objects, vegetation, or none for a place without an object.
// Or reads the objects of a truth file (*.truth.json). Throws Error, with ExitCode::usage when the file is at fault.
std::vector<TrainingPlace> read_training_places(const std::filesystem::path& path, const Crs& crs);

}  // namespace ilot
