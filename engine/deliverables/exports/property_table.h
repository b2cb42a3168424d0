// SPDX-License-Identifier: Apache-2.0
// Metadata of features in a glTF file [OGC 22-025r4: EXT_structural_metadata, EXT_mesh_features].
#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "engine/deliverables/exports/glb.h"

namespace ilot {

enum class PropertyType : std::uint8_t { text, real, whole, surface };

// `surface` is an enumeration: roof, wall, ground.
struct Property {
  std::string name;
  PropertyType type = PropertyType::text;
  std::string unit, meaning;
};

struct PropertyClass {
  std::string name;
  std::vector<Property> properties;
};

// A value that a feature does not have is an empty text, or kNoReal or kNoWhole, which the schema states.
constexpr double kNoReal = -9999;
constexpr std::int64_t kNoWhole = -9999;

using PropertyValue = std::variant<std::string, double, std::int64_t>;
using PropertyRow = std::vector<PropertyValue>;  // as many as properties, of their types; of a surface its number

// The schema of a file with these classes, and its tables, which begin empty: glb.json needs both in `extensions`.
nlohmann::ordered_json metadata_start(const std::vector<PropertyClass>& classes);

// Adds the columns of a table with at least one row to the file. Returns the table for `propertyTables`.
nlohmann::ordered_json property_table(Glb& glb, const PropertyClass& of, const std::vector<PropertyRow>& rows);

}  // namespace ilot
