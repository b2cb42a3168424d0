// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/pass/context.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// Writes the column "normals" (PackedNormal) of every block that lacks it. Neighbours are found across blocks. Where
// the k-th neighbour may lie outside of the points that were read, the query is repeated with a wider halo, up to
// normals.max_radius. The result is equal to that of one kNN over all points.
void normals_pass(const Store& store, const NormalsSettings& settings, const PassContext& context);

}  // namespace ilot
