// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/pass/context.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// Writes the column "normals" (PackedNormal) of every block that lacks it. Neighbours are found across blocks: where
// the k-th may lie outside what was read, the query is repeated with a wider halo, up to normals.max_radius. The answer
// is that of one kNN over all points.
void normals_pass(const Store& store, const NormalsSettings& settings, const PassContext& context);

}  // namespace ilot
