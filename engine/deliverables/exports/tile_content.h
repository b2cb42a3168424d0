// SPDX-License-Identifier: Apache-2.0
// What a tile shows, as a GLB file whose faces know their building and themselves.
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/exports/building_mesh.h"
#include "engine/deliverables/exports/placement.h"
#include "engine/deliverables/exports/property_table.h"
#include "engine/model/building.h"
#include "engine/model/street.h"

namespace ilot {

// A building, or an object of a street as the box of its measures.
struct TileModel {
  bool is_object = false;
  Building shape;                  // its vertices are not used: those of the mesh are in the frame of the tiles
  BuildingMesh mesh;               // vertices in metres, in that frame
  PropertyRow row;                 // of its class
  std::vector<PropertyRow> faces;  // of its surfaces; none of an object
};

// Classes of metadata: "building", with all attributes of building_fields() and none of a footprint, "face", "object".
const std::vector<PropertyClass>& tile_classes();

TileModel tile_model(const BuildingModel& building, const Building& solid, const Placement& placement,
                     double metres_per_unit);
TileModel tile_model(const StreetObject& object, const Placement& placement, double metres_per_unit);

// Returns the file. Features have the numbers of the rows in its tables: _FEATURE_ID_0 of a building and _FEATURE_ID_1
// of a face, or _FEATURE_ID_0 of an object. Vertices are float32 from a whole metre in the middle.
std::string tile_content(const std::vector<const TileModel*>& models, const std::string& name);

}  // namespace ilot
