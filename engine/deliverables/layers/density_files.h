// SPDX-License-Identifier: Apache-2.0
// Density maps as rasters, pictures and a table: docs/outputs.md.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/model/density_map.h"

namespace ilot {

// Writes folder/plane-NNNNNN.tif, .png and, with finish(), density.csv: one line for each map, in the order in which
// they were added. There are no time stamps. Throws Error when a file cannot be written; files that are complete stay.
class DensityFiles {
 public:
  // Creates the folder. metres_per_unit is that of the CRS.
  DensityFiles(std::filesystem::path folder, double metres_per_unit);
  void add(const DensityMap& map);
  void finish();

 private:
  std::filesystem::path folder_;
  double metres_per_unit_;
  std::string table_;
};

}  // namespace ilot
