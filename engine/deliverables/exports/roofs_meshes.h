// SPDX-License-Identifier: Apache-2.0
// roofs.stl and roofs.ply: all solids as triangles.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/deliverables/exports/export_frame.h"
#include "engine/formats/file.h"
#include "engine/model/building.h"

namespace ilot {

// Binary STL in CRS units from the frame's origin, which its header states: float32 would round coordinates of a
// national grid to decimetres. Written as buildings arrive. A place too far from the origin for a millimetre is an
// Error.
class RoofsStl {
 public:
  RoofsStl(const std::filesystem::path& path, const ExportFrame& frame);
  void add(const BuildingModel& model);
  void finish();

 private:
  OutputFile file_;
  ExportFrame frame_;
  std::uint32_t triangles_ = 0;
};

// Binary PLY with coordinates of the CRS as float64, so that no offset is needed. A face has its colour, `building`,
// its line in roofs.city.jsonl without the first, from 1, and `kind`: 0 roof, 1 wall, 2 ground. Vertices are written as
// they arrive; faces, 21 bytes each, are held until finish().
class RoofsPly {
 public:
  RoofsPly(const std::filesystem::path& path, const ExportFrame& frame);
  void add(const BuildingModel& model);
  void finish();

 private:
  std::string header() const;

  OutputFile file_;
  ExportFrame frame_;
  std::string faces_;
  std::uint32_t vertices_ = 0, triangles_ = 0, building_ = 0;
};

}  // namespace ilot
