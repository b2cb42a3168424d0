// SPDX-License-Identifier: Apache-2.0
// Where the coordinates of exported files begin, and what the coordinates of the result are.
#pragma once
#include <string>

#include "engine/cloud/cloud_info.h"
#include "kernels/core/types.h"

namespace ilot {

struct ExportFrame {
  Vec3 origin;                 // CRS units; whole thousands, near the content
  double metres_per_unit = 1;  // of all three axes
  Crs crs;                     // without WKT when it is unknown
  std::string crs_name;        // as run.json has it: "EPSG:2154", else a name; empty when it is unknown

  // Metres from the origin.
  Vec3 at(Vec3 p) const { return metres_per_unit * (p - origin); }
};

// Returns the place with its coordinates rounded down to whole thousands; heights begin at 0.
Vec3 export_origin(Vec3 place);

}  // namespace ilot
