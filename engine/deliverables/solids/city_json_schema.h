// SPDX-License-Identifier: Apache-2.0
// The rules of CityJSON (cityjson.org/specs) that readers rely on, with words for what breaks them.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/deliverables/solids/solid_file.h"

namespace ilot {

// What a document says of itself, for its objects and for the features after it.
struct CityJsonHead {
  std::string version;        // 1.0, 1.1, 2.0; empty = none that is known
  std::size_t templates = 0;  // number of geometry templates

  bool integer_vertices() const { return version != "1.0"; }
};

// Faults of a CityJSON object outside of its CityObjects: type, version, transform, metadata, vertices, templates.
std::vector<FormatFault> check_city_json_head(const nlohmann::json& root, CityJsonHead& head);

// Faults of a CityJSONFeature outside of its CityObjects.
std::vector<FormatFault> check_city_json_feature(const nlohmann::json& root, const CityJsonHead& head);

// Faults of all objects: types, parents and children, geometries.
std::vector<FormatFault> check_city_objects(const nlohmann::json& objects, std::size_t vertices,
                                            const CityJsonHead& head);

// What is wrong with one geometry; empty when nothing is.
std::string geometry_fault(const nlohmann::json& geometry, std::size_t vertices, const CityJsonHead& head);

}  // namespace ilot
