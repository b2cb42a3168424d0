// SPDX-License-Identifier: Apache-2.0
// The data and settings that the modelling of all buildings of a run shares.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/deliverables/solids/roof_files.h"
#include "engine/pass/context.h"
#include "engine/products/roofs/edits/class_edits.h"
#include "engine/products/roofs/edits/face_merges.h"
#include "engine/products/roofs/site_modeller.h"
#include "engine/settings/settings.h"

namespace ilot {

// What the files of roofs say of the whole run: it needs all points and all outlines.
struct RoofFrame {
  Vec3 origin;                                  // of the coordinates in the files, CRS units
  std::optional<std::array<double, 6>> extent;  // least and greatest x, y, z; CRS units
  Columns further;                              // the attributes of the footprints
};

// The outlines of the sites, by their numbers.
OutlineMap map_of_outlines(std::span<const PlannedSite> sites);

// Returns the frame of a run with these points (their box in lattice steps of `unit`) and sites.
RoofFrame roof_frame(const IndexBox& points, double unit, std::span<const PlannedSite> sites,
                     const PassContext& context);

// Returns the parameters of the files for a frame.
RoofFilesParams roof_files_params(const RoofFrame& frame, const Settings& settings, const Crs& crs);

// The setup refers to the store, the sites and the edits, which must outlive it. The edits of classes have been made on
// the store.
struct RoofSetup {
  RoofSetup(const Store& store, std::span<const PlannedSite> sites, const Settings& settings, const Crs& crs,
            const PassContext& context, std::span<const Edit> edits = {});
  RoofSetup(const RoofSetup&) = delete;
  RoofSetup& operator=(const RoofSetup&) = delete;

  OutlineMap map;
  ClassEdits class_edits;
  std::vector<PlannedMerge> merges;
  SiteWork work;
  RoofModelParams model;
  RoofFilesParams file;
};

}  // namespace ilot
