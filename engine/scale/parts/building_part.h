// SPDX-License-Identifier: Apache-2.0
// What a task does for roofs: it makes the buildings whose outlines its area owns.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/report/progress.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/plan.h"
#include "engine/scale/records.h"
#include "engine/store/store.h"

namespace ilot {

// The sites of an area and the outlines around them, in the order of all sites.
struct LocalSites {
  std::vector<PlannedSite> sites;
  std::vector<bool> outside;
  std::vector<std::size_t> own;      // places in the lists above
  std::vector<std::size_t> sampled;  // places in the list `own`
};

// Reads the sites of an area. Throws Error where the file is damaged or of another plan.
LocalSites read_sites(const std::filesystem::path& path, const PlanArea& area);

// Makes the own buildings, from a store with the column "role", and adds each as a record, then the labels that they
// give to points where the plan carries these. Fills in what the end of the part says.
void write_buildings(const Store& store, const LocalSites& local, const Plan& plan, const PassContext& context,
                     Progress& progress, RecordFileWriter& part, PartSummary& summary);

}  // namespace ilot
