// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// The sites of a cloud without footprints: clusters of the points whose column "role" is building, each with the
// outline of its points; ids tell where their first points lie, in steps of the lattice. Clusters of too few points are
// counted in the record. The distance that parts clusters is chosen for the whole cloud.
std::vector<PlannedSite> plan_clusters(const Store& store, const RoofsSettings& settings, const PassContext& context,
                                       Progress& progress, RunRecord& record);

}  // namespace ilot
