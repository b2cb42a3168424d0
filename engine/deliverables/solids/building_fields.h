// SPDX-License-Identifier: Apache-2.0
// Attributes of buildings and their faces: names, types, meaning, and what they are called elsewhere.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "engine/model/building_geometry.h"
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

// In the order of docs/outputs.md, which is made of this.
std::span<const BuildingField> building_fields();
std::span<const BuildingField> face_fields();

using Attributes = std::vector<std::pair<std::string, AttributeValue>>;

// The attributes of a building, levels of detail as they are written, in a style. roofer's style renames, and adds what
// follows from others: rf_success, rf_extrusion_mode, rf_nodata_frac, rf_pt_density, rf_volume_lod12 and _lod22.
// Attributes that are in no table stay as they are.
Attributes styled_attributes(std::span<const Building> levels, AttributeStyle style, double metres_per_unit);

// The columns that styled_attributes() may give, with their kinds; those of faces, plane_id first.
std::vector<std::pair<std::string, FieldKind>> attribute_columns(AttributeStyle style);
std::vector<std::pair<std::string, FieldKind>> face_columns(AttributeStyle style);

// Of a roof face: slope, azimuth (not for level ones) and area.
Attributes face_attributes(const SurfaceShape& shape, AttributeStyle style);

// Both tables as docs/outputs.md shows them.
std::string building_fields_markdown();

}  // namespace ilot
