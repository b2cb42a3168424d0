// SPDX-License-Identifier: Apache-2.0
// Checks whether geometries are valid in the sense of ISO 19107. Rules, numbers, tolerances and the order in which one
// check stops the next are those of val3dity 2.6 (val3dity.readthedocs.io/errors; Ledoux 2018, "val3dity: validation of
// 3D GIS primitives according to the international standards"). The checks are exact on a lattice of a micrometre.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/building.h"
#include "engine/model/solid_model.h"

namespace ilot {

struct ValidityParams {
  double snap = 0.001;            // CRS units; vertices of a shell at most this far apart are one
  double plane_distance = 0.01;   // CRS units; greatest distance of a vertex from its face's plane
  double plane_normals_deg = 20;  // largest angle between a face's triangles
};

struct Fault {
  int code = 0;
  std::string where;  // primitive, shell, face; place or size of the fault
};

using Faults = std::vector<Fault>;

// The name of a code: CONSECUTIVE_POINTS_SAME for 102, and so on; UNKNOWN_ERROR for other numbers.
const char* validity_code_name(int code);

// The codes of the faults, each once, ascending.
std::vector<int> codes_of(const Faults& faults);

// Returns all faults of an object: those of its primitives in order and, for Buildings, whether primitives of one level
// of detail overlap (601). Without faults the object is valid; an object without geometries is valid too. The function
// never throws because of the geometries. It takes about half a millisecond for a solid of 50 faces.
Faults validate_object(const CityObject& object, const ValidityParams& params = {});

// The same for one building before it is written, with its vertices rounded to whole `step`s from `origin`, as the
// CityJSON writer rounds them. It is a solid, or a MultiSurface for levels 0 to 0.9. Without surfaces it is empty
// (902).
Faults validate_building(const Building& building, Vec3 origin, double step, const ValidityParams& params = {});

}  // namespace ilot
