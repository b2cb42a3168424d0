// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/pass/context.h"
#include "engine/products/product_output.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// Turns sites into buildings, from a store with the column "role" (PointRole). It gathers the points of each site,
// models it, and writes roofs.city.jsonl into the folder (and .json when it is not too large) in the order of the
// sites, and the column "roof" (RoofLabel) of every block. Sites are processed in parallel, in batches of some hundred
// with the largest first. Each result depends only on the site's own points and its neighbours' outlines. With
// `context.wanted`, only sites whose first vertex is wanted are processed. Adds the stage "roofs" and the counts.
void make_roofs(const Store& store, std::span<const PlannedSite> sites, const Settings& settings, const Crs& crs,
                const PassContext& context, const ProductOutput& out);

}  // namespace ilot
