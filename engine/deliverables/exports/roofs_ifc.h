// SPDX-License-Identifier: Apache-2.0
// roofs.ifc: envelopes of buildings in IFC 4.3.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/deliverables/exports/step_file.h"
#include "engine/model/building.h"

namespace ilot {

// An IfcBuilding for each building with a solid; its envelope is an IfcBuildingElementProxy with a closed
// IfcPolygonalFaceSet, in metres from a whole metre near it. Its attributes are a property set. Written as buildings
// arrive.
class RoofsIfc {
 public:
  RoofsIfc(const std::filesystem::path& path, const ExportFrame& frame);
  void add(const BuildingModel& model);
  void finish();

 private:
  StepFile file_;
  ExportFrame frame_;
  IfcModel model_;
  std::vector<StepId> buildings_;
};

}  // namespace ilot
