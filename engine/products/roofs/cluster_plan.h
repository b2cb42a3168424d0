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

// Plans the sites of a cloud without footprints. They are clusters of the points whose column "role" is building, each
// with the outline of its points. An id is made from the position of the first point of the cluster, in steps of the
// lattice. Clusters with too few points are counted in the record. The distance that separates clusters is chosen for
// the whole cloud.
std::vector<PlannedSite> plan_clusters(const Store& store, const RoofsSettings& settings, const PassContext& context,
                                       Progress& progress, RunRecord& record);

// The distance in metres that suits the points whose column "role" is building: roofs.cluster_distance where
// it is not set.
double suitable_cluster_distance(const Store& store, const PassContext& context);

}  // namespace ilot
