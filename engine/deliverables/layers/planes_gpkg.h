// SPDX-License-Identifier: Apache-2.0
// planes.gpkg: the outline of every plane as a polygon with holes in space. Columns: docs/outputs.md.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/cloud/cloud_info.h"
#include "engine/model/outline.h"
#include "engine/model/segment.h"

namespace ilot {

// Writes one feature for each plane, in the order in which they are added. The file is complete after finish(); without
// it, no file remains. There are no time stamps. Throws Error when the file cannot be written.
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
