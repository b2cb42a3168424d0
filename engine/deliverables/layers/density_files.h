// SPDX-License-Identifier: Apache-2.0
// Density maps as rasters, pictures and a table: docs/outputs.md.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/model/density_map.h"

namespace ilot {

// Writes folder/plane-NNNNNN.tif, .png and, with finish(), density.csv: a line a map, in the order they were added. No
// time stamps. Throws Error when a file cannot be written; those that are whole stay.
class DensityFiles {
 public:
  // The folder is made. metres_per_unit: of the CRS.
  DensityFiles(std::filesystem::path folder, double metres_per_unit);
  void add(const DensityMap& map);
  void finish();

 private:
  std::filesystem::path folder_;
  double metres_per_unit_;
  std::string table_;
};

}  // namespace ilot
