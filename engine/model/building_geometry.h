// SPDX-License-Identifier: Apache-2.0
// What can be measured on a building's model.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/model/building.h"

namespace ilot {

struct SurfaceShape {
  double area_m2 = 0;
  double slope_deg = 0;     // between the surface and the level, 0 to 90 for roofs
  double azimuth_deg = -1;  // where it looks, clockwise from north; -1 for level surfaces
};

// Of a face in space, holes taken off. Zeros for faces without an area. O(corners).
SurfaceShape surface_shape(const Building& building, const BuildingSurface& surface, double metres_per_unit);

// What a closed solid encloses. O(corners).
double volume_m3(const Building& building, double metres_per_unit);

}  // namespace ilot
