// SPDX-License-Identifier: Apache-2.0
// roofs.glb: all solids in one glTF file, a node a building with its attributes.
#pragma once
#include <filesystem>

#include "engine/deliverables/exports/export_frame.h"
#include "engine/deliverables/exports/glb.h"
#include "engine/model/building.h"

namespace ilot {

// Metres. The node at the root turns z up to y up and moves by the frame's origin; its extras state both the CRS and
// that origin. Each building's vertices are float32 from a whole metre near it. All is held in memory until finish(),
// when the file appears whole. Throws Error.
class RoofsGlb {
 public:
  RoofsGlb(const std::filesystem::path& path, const ExportFrame& frame);
  void add(const BuildingModel& model);  // one without a solid is left out
  void finish();

 private:
  std::filesystem::path path_;
  ExportFrame frame_;
  Glb glb_;
};

}  // namespace ilot
