// SPDX-License-Identifier: Apache-2.0
// roofs.gpkg: layer `buildings`, outlines on the ground with the buildings' attributes, and layer `roof_faces`,
// polygons in space with theirs. Columns: docs/outputs.md.
#pragma once
#include <filesystem>
#include <memory>
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/deliverables/solids/building_fields.h"

namespace ilot {

// Buildings in the order they are added; the faces are those of the last level that has any. The file is whole after
// finish(); without it, none is left. Throws Error when it cannot be written.
class RoofsGpkg {
 public:
  RoofsGpkg(const std::filesystem::path& path, const Crs& crs, AttributeStyle style, double metres_per_unit);
  ~RoofsGpkg();
  void add(std::span<const Building> levels);
  void finish();

 private:
  struct Layers;
  std::unique_ptr<Layers> layers_;
};

}  // namespace ilot
