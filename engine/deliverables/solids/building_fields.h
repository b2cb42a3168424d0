// SPDX-License-Identifier: Apache-2.0
// Attributes of buildings and of their faces: names, types, meaning, and their names in other software.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "engine/model/building_geometry.h"
#include "engine/model/face_heights.h"
#include "engine/settings/settings.h"

namespace ilot {

enum class FieldKind : std::uint8_t { whole, real, text, truth };

struct BuildingField {
  const char* name;
  FieldKind kind;
  const char* unit;
  const char* meaning;  // Markdown
  const char* roofer;   // name in that style; nullptr = the same name
};

// The fields are in the order of docs/outputs.md, which is generated from them.
std::span<const BuildingField> building_fields();
std::span<const BuildingField> face_fields();

using Attributes = std::vector<std::pair<std::string, AttributeValue>>;
using Columns = std::vector<std::pair<std::string, FieldKind>>;

// Returns the attributes of a building in a style. roofer's style renames attributes and adds those that follow from
// others: rf_success, rf_extrusion_mode, rf_nodata_frac and rf_pt_density. Attributes that are in no table stay as they
// are.
Attributes styled_attributes(const Attributes& plain, AttributeStyle style);

// Return the columns that styled_attributes() may give, with their kinds, and the columns of faces, plane_id first.
std::vector<std::pair<std::string, FieldKind>> attribute_columns(AttributeStyle style);
std::vector<std::pair<std::string, FieldKind>> face_columns(AttributeStyle style);

// Returns the names that a result may have for the field: its own, then those of roofer's style.
std::vector<std::string> names_of(const BuildingField& field);

// True for the names of the tables, in both styles; others are a footprint's.
bool is_measured(const std::string& name);

// Returns slope, azimuth (not for horizontal faces), area and heights of a roof face.
Attributes face_attributes(const SurfaceShape& shape, const FaceHeights& heights, AttributeStyle style);

// The same of a face of a building.
Attributes face_attributes(const Building& building, const BuildingSurface& surface, AttributeStyle style,
                           double metres_per_unit);

// Returns both tables as docs/outputs.md shows them.
std::string building_fields_markdown();

}  // namespace ilot
