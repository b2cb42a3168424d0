// SPDX-License-Identifier: Apache-2.0
// Reports on footprints from which no building was made.
#pragma once
#include <set>
#include <span>
#include <string>

#include "engine/pass/context.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/store/store.h"

namespace ilot {

// The extent of points in millimetres, the unit of outlines, from their box in lattice steps.
GridBox extent_of_points(const IndexBox& points, double step_metres);

// The ids of sites, and of those whose outlines lie wholly outside of an extent.
struct SiteNames {
  std::set<std::string> all, beyond;
  std::size_t sites = 0;
};
SiteNames names_of(std::span<const PlannedSite> sites, const GridBox& extent);

// Reports which footprints were skipped. A footprint that lies wholly outside of the cloud's extent is no fault,
// because footprints of a whole town are usual. Such footprints move from record.skipped to record.footprints->outside
// and are reported in one line.
void resolve_skipped_footprints(const SiteNames& names, Progress& progress, RunRecord& record);

// Returns half a sentence that explains why there are no roofs to build. `sites` are those of the footprints; `given`:
// there is a file of footprints; `area`: products are wanted in a part only. `extent` of the points and `crs` say where
// the clouds are.
std::string why_no_building(std::span<const PlannedSite> sites, bool given, bool area, const GridBox& extent,
                            const CrsRecord& crs);

}  // namespace ilot
