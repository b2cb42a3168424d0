// SPDX-License-Identifier: Apache-2.0
// roofs.gml: CityGML 2.0 [OGC 12-019].
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/deliverables/exports/export_frame.h"
#include "engine/formats/file.h"
#include "engine/model/building.h"

namespace ilot {

// A bldg:Building for each building, with or without a solid, in their order and with their attributes as generic ones.
// The level 2.2 is its lod2Solid, whose faces are those of its bounding surfaces; 1.2 is its lod1Solid and 0 its
// lod0FootPrint. Coordinates in the CRS, to a tenth of a thousandth. Written as buildings arrive.
class RoofsGml {
 public:
  RoofsGml(const std::filesystem::path& path, const ExportFrame& frame);
  void add(const BuildingModel& model);
  void finish();

 private:
  void append(const std::string& text);

  OutputFile file_;
  std::string srs_;  // attributes of geometries; empty when the CRS is unknown
  std::uint64_t building_ = 0;
};

}  // namespace ilot
