// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/columns/point_roles.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// What ground and buildings are where nobody has said so: rewrites the column "role" of the unclassified points. Ground
// is what lies within 0.5 m of the ground's surface (engine/columns/ground_surface.h), buildings are points from 2 m up
// where most are smooth (building_mask.h). Needs "normals" and "echoes". Works in tiles of 128 pixels of about a metre
// on the lattice with all the halo they need: no seam shows.
RoleCounts find_roles(const Store& store, const PassContext& context);

}  // namespace ilot
