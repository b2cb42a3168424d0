// SPDX-License-Identifier: Apache-2.0
// The rules of CityJSON (cityjson.org/specs) that readers depend on, with a message for each violation.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/deliverables/solids/solid_file.h"

namespace ilot {

// What a document declares for itself, for its objects and for the features after it.
struct CityJsonHead {
  std::string version;        // 1.0, 1.1, 2.0; empty = no known version
  std::size_t templates = 0;  // number of geometry templates

  bool integer_vertices() const { return version != "1.0"; }
};

// Returns the faults of a CityJSON object outside its CityObjects: type, version, transform, metadata, vertices,
// templates.
std::vector<FormatFault> check_city_json_head(const nlohmann::json& root, CityJsonHead& head);

// Returns the faults of a CityJSONFeature outside its CityObjects.
std::vector<FormatFault> check_city_json_feature(const nlohmann::json& root, const CityJsonHead& head);

// Returns the faults of all objects: types, parents and children, geometries.
std::vector<FormatFault> check_city_objects(const nlohmann::json& objects, std::size_t vertices,
                                            const CityJsonHead& head);

// Returns the fault of one geometry; empty when it has none.
std::string geometry_fault(const nlohmann::json& geometry, std::size_t vertices, const CityJsonHead& head);

}  // namespace ilot
