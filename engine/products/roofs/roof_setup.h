// SPDX-License-Identifier: Apache-2.0
// The data and settings that the modelling of all buildings of a run shares.
#pragma once
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/deliverables/solids/roof_files.h"
#include "engine/pass/context.h"
#include "engine/products/roofs/site_modeller.h"
#include "engine/settings/settings.h"

namespace ilot {

// The setup refers to the store and the sites, which must outlive it.
struct RoofSetup {
  RoofSetup(const Store& store, std::span<const PlannedSite> sites, const Settings& settings, const Crs& crs,
            const PassContext& context);
  RoofSetup(const RoofSetup&) = delete;
  RoofSetup& operator=(const RoofSetup&) = delete;

  OutlineMap map;
  SiteWork work;
  RoofModelParams model;
  RoofFilesParams file;
};

}  // namespace ilot
