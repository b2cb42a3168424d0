// SPDX-License-Identifier: Apache-2.0
// Are geometries valid in the sense of ISO 19107? Rules, numbers, tolerances and where one check stops the next are
// those of val3dity 2.6 (val3dity.readthedocs.io/errors; Ledoux 2018, "val3dity: validation of 3D GIS primitives
// according to the international standards"). Decided on a lattice of a micrometre, exactly.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/building.h"
#include "engine/model/solid_model.h"

namespace ilot {

struct ValidityParams {
  double snap = 0.001;            // CRS units: vertices of a shell at most as far apart are one
  double plane_distance = 0.01;   // CRS units: farthest that a vertex lies from its face's plane
  double plane_normals_deg = 20;  // largest angle between a face's triangles
};

struct Fault {
  int code = 0;
  std::string where;  // which primitive, shell, face; the place or the size of the fault
};

using Faults = std::vector<Fault>;

// CONSECUTIVE_POINTS_SAME for 102, and so on; UNKNOWN_ERROR for other numbers.
const char* validity_code_name(int code);

// The codes of the faults, each once, ascending.
std::vector<int> codes_of(const Faults& faults);

// All faults of an object: of its primitives in order, and of Buildings whether primitives of one level of detail
// overlap (601). No faults: valid, which an object without geometries is. Never throws for what geometries hold.
// About half a millisecond for a solid of 50 faces.
Faults validate_object(const CityObject& object, const ValidityParams& params = {});

// The same of one building as it is about to be written, its vertices rounded to whole `step`s from `origin`, as the
// CityJSON writer does: a solid, or a MultiSurface for levels 0 to 0.9. Without surfaces it is empty (902).
Faults validate_building(const Building& building, Vec3 origin, double step, const ValidityParams& params = {});

}  // namespace ilot
