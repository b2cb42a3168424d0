// SPDX-License-Identifier: Apache-2.0
// planes.gpkg: the outline of every plane as a polygon with holes in space. Columns: docs/outputs.md.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/cloud/cloud_info.h"
#include "engine/model/outline.h"
#include "engine/model/segment.h"

namespace ilot {

// One feature per plane, in the order they are added. The file is whole after finish(); without it, none is left. No
// time stamps. Throws Error when the file cannot be written.
class PlanesGpkg {
 public:
  PlanesGpkg(const std::filesystem::path& path, const Crs& crs);
  ~PlanesGpkg();
  void add(const Segment& segment, Outline outline);
  void finish();

 private:
  struct Layer;
  std::unique_ptr<Layer> layer_;
};

}  // namespace ilot
