// SPDX-License-Identifier: Apache-2.0
// roofs.gpkg: layer `buildings` has the outlines on the ground with the attributes of the buildings, layer `roof_faces`
// has polygons in space with the attributes of the faces. Columns: docs/outputs.md.
#pragma once
#include <filesystem>
#include <memory>
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/deliverables/solids/building_fields.h"

namespace ilot {

// Buildings are written in the order in which they are added. The faces are those of the last level that has any. The
// file is complete after finish(); without it, no file remains. Throws Error when it cannot be written.
class RoofsGpkg {
 public:
  // `further`: columns for attributes of buildings that are in no table, those of footprints.
  RoofsGpkg(const std::filesystem::path& path, const Crs& crs, AttributeStyle style, double metres_per_unit,
            const Columns& further = {});
  ~RoofsGpkg();
  void add(std::span<const Building> levels);
  void finish();

 private:
  struct Layers;
  std::unique_ptr<Layers> layers_;
};

}  // namespace ilot
