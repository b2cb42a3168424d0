// SPDX-License-Identifier: Apache-2.0
// Places and classes of street objects, from which the classifier is trained.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "kernels/core/types.h"

namespace ilot {

struct TrainingPlace {
  Vec3 at;           // in the CRS of the clouds; for an area, its middle
  std::string name;  // of its class; none, vegetation, a class of street objects, or one's own
};

// Reads the first layer with features of any vector file that GDAL reads. Its points or polygons have the text
// attribute `class` (in any case): a class of street objects, vegetation, none for a place without an object, or any
// other name of up to 40 letters, digits, blanks and _ - . / for a class of one's own. Or reads the objects of a truth
// file (*.truth.json). Throws Error, with ExitCode::usage when the file is at fault.
std::vector<TrainingPlace> read_training_places(const std::filesystem::path& path, const Crs& crs);

}  // namespace ilot
