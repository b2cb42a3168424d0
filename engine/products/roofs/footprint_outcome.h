// SPDX-License-Identifier: Apache-2.0
// What is said of footprints that came to nothing.
#pragma once
#include <span>
#include <string>

#include "engine/pass/context.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/store/store.h"

namespace ilot {

// Says which footprints were skipped. Those wholly outside of the cloud's extent are no fault, as footprints of a whole
// town are usual: they move from record.skipped to record.footprints->outside and become one line.
void resolve_skipped_footprints(const Store& store, std::span<const PlannedSite> sites, const PassContext& context,
                                Progress& progress, RunRecord& record);

// Why roofs found nothing to build: half a sentence. `sites` are those of the footprints, `given`: there is a file of
// them, `area`: products are asked for in a part only.
std::string why_no_building(std::span<const PlannedSite> sites, bool given, bool area);

}  // namespace ilot
