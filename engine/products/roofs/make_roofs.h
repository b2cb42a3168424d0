// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "engine/columns/run_inputs.h"
#include "engine/model/facade_opening.h"
#include "engine/pass/context.h"
#include "engine/products/product_output.h"
#include "engine/products/roofs/roof_setup.h"
#include "engine/products/roofs/sites/misalignment.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// Takes the result of a site, by its place in the list of sites that are modelled. Called in the order of the list.
using TakeSite = std::function<void(std::size_t place, SiteResult& result)>;

// Models the sites with these numbers in setup.work.sites, which are ascending. Adds the stage "roofs", which the
// caller ends. Returns how the points lie in shifted outlines of the sample, which has places in `sites`.
ShiftCounts model_buildings(const RoofSetup& setup, std::span<const std::size_t> sites,
                            std::span<const std::size_t> sample, const PassContext& context, Progress& progress,
                            RoofLabels& labels, const TakeSite& take);

// Returns the places of at most 64 sites, evenly spread, by which a misalignment of outlines is measured.
std::vector<std::size_t> sample_of_sites(std::size_t sites);

// Records how far the outlines lie beside the points, and warns where moving them is worth it.
void record_misalignment(const ShiftCounts& counts, Progress& progress, RunRecord& record);

// The sites that share ground with others, in the order of ids.
std::vector<OverlapRecord> overlaps_of(std::span<const PlannedSite> sites, const OutlineMap& map);

// Turns sites into buildings, from a store with the column "role" (PointRole). It gathers the points of each site,
// models it, and writes roofs.city.jsonl into the folder (and .json when it is not too large) in the order of the
// sites, and the column "roof" (RoofLabel) of every block. Sites are processed in parallel, in batches of some hundred
// with the largest first. Each result depends only on the site's own points and its neighbours' outlines. With
// `context.wanted`, only sites whose first vertex is wanted are processed. Adds the stage "roofs" and the counts, those
// of edits that merge faces too. `openings` are those of the facades of the run, by which storeys are counted.
void make_roofs(const Store& store, std::span<const PlannedSite> sites, std::span<const FacadeOpening> openings,
                const Settings& settings, const RunInputs& inputs, const PassContext& context,
                const ProductOutput& out);

}  // namespace ilot
