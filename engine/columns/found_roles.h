// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/columns/building_mask.h"
#include "engine/columns/ground_surface.h"
#include "engine/columns/point_roles.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// Choice: a pixel of a metre gets a point even at one a square metre; narrower alleys are lost.
constexpr double kRolePixelMetres = 1.1;  // largest side of a pixel

// Points farther in plan than this from a point do not change its role, beside the normals of points within it.
// Derived: the two halos, and one pixel for the point's own.
constexpr double kFoundRolesReach = (kGroundHalo + kMaskHalo + 1) * kRolePixelMetres;  // metres

struct FoundRolesParams {
  double ground_within = 0.5;  // metres from the surface of the ground
  double least_height = 2;     // metres of a building above that surface
  double smoothness = 0.06;    // greatest curvature of the points of a roof
};

// Finds ground and buildings where points are not classified: rewrites the column "role" of these points. A point
// within ground_within of the surface of the ground (engine/columns/ground_surface.h) is ground. A point at least
// least_height above the ground where most points are smooth (building_mask.h) is a building. Needs "normals" and
// "echoes". The work is done in tiles of 128 pixels of about a metre on the lattice, with the full halo that they need,
// so that there are no seams.
RoleCounts find_roles(const Store& store, const FoundRolesParams& params, const PassContext& context);

}  // namespace ilot
