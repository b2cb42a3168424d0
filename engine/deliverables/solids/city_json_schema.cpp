// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/city_json_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/deliverables/solids/json_parts.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

// Types of the second level are parts of other objects and name them as parents.
constexpr std::string_view kFirstLevel[] = {"Bridge",
                                            "Building",
                                            "CityFurniture",
                                            "CityObjectGroup",
                                            "GenericCityObject",
                                            "LandUse",
                                            "OtherConstruction",
                                            "PlantCover",
                                            "Railway",
                                            "Road",
                                            "SolitaryVegetationObject",
                                            "TINRelief",
                                            "TransportSquare",
                                            "Tunnel",
                                            "WaterBody",
                                            "Waterway"};
constexpr std::string_view kSecondLevel[] = {"BridgePart",
                                             "BridgeInstallation",
                                             "BridgeConstructiveElement",
                                             "BridgeRoom",
                                             "BridgeFurniture",
                                             "BuildingPart",
                                             "BuildingInstallation",
                                             "BuildingConstructiveElement",
                                             "BuildingFurniture",
                                             "BuildingStorey",
                                             "BuildingRoom",
                                             "BuildingUnit",
                                             "TunnelPart",
                                             "TunnelInstallation",
                                             "TunnelConstructiveElement",
                                             "TunnelHollowSpace",
                                             "TunnelFurniture"};
constexpr std::string_view kSurfaces[] = {
    "RoofSurface",           "GroundSurface",       "WallSurface",  "ClosureSurface",
    "OuterCeilingSurface",   "OuterFloorSurface",   "Window",       "Door",
    "InteriorWallSurface",   "CeilingSurface",      "FloorSurface", "WaterSurface",
    "WaterGroundSurface",    "WaterClosureSurface", "TrafficArea",  "AuxiliaryTrafficArea",
    "TransportationMarking", "TransportationHole"};

struct GeometryShape {
  std::string_view type;
  int depth;  // of the boundaries: depth of the nested lists
};
constexpr GeometryShape kShapes[] = {{"MultiPoint", 1},       {"MultiLineString", 2}, {"MultiSurface", 3},
                                     {"CompositeSurface", 3}, {"Solid", 4},           {"MultiSolid", 5},
                                     {"CompositeSolid", 5}};

template <class List>
bool is_listed(const List& list, std::string_view value) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

std::string_view text_of(const Json& value) {
  return value.is_string() ? std::string_view(value.get_ref<const std::string&>()) : std::string_view();
}

bool is_finite_number(const Json& value) {
  return value.is_number() && std::isfinite(value.get<double>());
}

bool has_numbers(const Json& list, std::size_t size) {
  return list.is_array() && list.size() == size && std::all_of(list.begin(), list.end(), is_finite_number);
}

bool is_index(const Json& value, std::size_t limit) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() < limit;
}

std::string check_transform(const Json& transform) {
  if (!transform.is_object()) return "transform is no object";
  if (!has_numbers(json_field(transform, "scale"), 3)) return "transform.scale is not three numbers";
  if (!has_numbers(json_field(transform, "translate"), 3)) return "transform.translate is not three numbers";
  return "";
}

std::string check_metadata(const Json& metadata) {
  if (metadata.is_null()) return "";
  if (!metadata.is_object()) return "metadata is no object";
  const Json& extent = json_field(metadata, "geographicalExtent");
  if (!extent.is_null() && !has_numbers(extent, 6)) return "metadata.geographicalExtent is not six numbers";
  const Json& system = json_field(metadata, "referenceSystem");
  if (!system.is_null() && !system.is_string()) return "metadata.referenceSystem is no text";
  return "";
}

// Since 1.1 it is a URL of the OGC: https://www.opengis.net/def/crs/EPSG/0/7415.
std::string check_reference_system(const Json& metadata, const CityJsonHead& head) {
  const std::string_view system = text_of(json_field(metadata, "referenceSystem"));
  if (system.empty() || head.version == "1.0") return "";
  for (const std::string_view start : {"http://www.opengis.net/def/crs/", "https://www.opengis.net/def/crs/"})
    if (system.starts_with(start) &&
        std::count(system.begin() + static_cast<std::ptrdiff_t>(start.size()), system.end(), '/') == 2)
      return "";
  return fmt::format("metadata.referenceSystem '{}' is not https://www.opengis.net/def/crs/AUTHORITY/VERSION/CODE",
                     system);
}

std::string check_vertices(const Json& vertices, bool integers) {
  if (!vertices.is_array()) return "vertices is missing or no list";
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!has_numbers(vertices[i], 3)) return fmt::format("vertex {} is not three numbers", i);
    for (const Json& c : vertices[i])
      if (integers && !c.is_number_integer()) return fmt::format("vertex {} is not three whole numbers", i);
  }
  return "";
}

void note(std::vector<FormatFault>& faults, const std::string& object, std::string text) {
  if (!text.empty()) faults.push_back({object, std::move(text)});
}

// Checks the depth of lists, with whole numbers below `limit` at the bottom. Returns the fault, or an empty text.
std::string check_nesting(const Json& value, int depth, std::size_t limit, bool nulls) {
  if (depth == 0) {
    if (is_index(value, limit) || (nulls && value.is_null())) return "";
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 40);
    return fmt::format("{} is none of {}", text, limit);
  }
  if (nulls && value.is_null()) return "";
  if (!value.is_array()) return "lists are not nested as the type asks";
  for (const Json& part : value)
    if (std::string what = check_nesting(part, depth - 1, limit, nulls); !what.empty()) return what;
  return "";
}

// Values must have the shape of the boundaries down to surfaces.
std::string check_same_shape(const Json& values, const Json& boundaries, int depth) {
  if (values.is_null() || depth == 0) return "";
  if (values.size() != boundaries.size())
    return fmt::format("semantics.values has {} entries where boundaries has {}", values.size(), boundaries.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::string what = check_same_shape(values[i], boundaries[i], depth - 1); !what.empty()) return what;
  return "";
}

std::string check_surfaces(const Json& surfaces) {
  if (!surfaces.is_array()) return "semantics.surfaces is missing or no list";
  for (const Json& surface : surfaces) {
    const std::string_view type = text_of(json_field(surface, "type"));
    if (type.empty()) return "a semantic surface has no type";
    if (type[0] != '+' && !is_listed(kSurfaces, type)) return fmt::format("'{}' is no type of surface", type);
  }
  return "";
}

std::string check_semantics(const Json& semantics, const Json& boundaries, int depth) {
  if (semantics.is_null()) return "";
  if (!semantics.is_object()) return "semantics is no object";
  const Json& surfaces = json_field(semantics, "surfaces");
  if (std::string what = check_surfaces(surfaces); !what.empty()) return what;
  const int levels = depth <= 2 ? 1 : depth - 2;  // points and lines have the values themselves
  const Json& values = json_field(semantics, "values");
  if (values.is_null()) return semantics.contains("values") ? "" : "semantics.values is missing";
  if (std::string what = check_nesting(values, levels, surfaces.size(), true); !what.empty())
    return "semantics.values: " + what;
  return check_same_shape(values, boundaries, levels);
}

std::string check_lod(const Json& lod, const CityJsonHead& head) {
  if (lod.is_null()) return "lod is missing";
  if (head.version == "1.0") return lod.is_number() || lod.is_string() ? "" : "lod is no number";
  const std::string_view text = text_of(lod);
  const bool right = (text.size() == 1 || (text.size() == 3 && text[1] == '.' && text[2] >= '0' && text[2] <= '3')) &&
                     text[0] >= '0' && text[0] <= '3';
  return right ? "" : "lod is not a text from \"0\" to \"3.3\"";
}

std::string check_instance(const Json& geometry, std::size_t vertices, const CityJsonHead& head) {
  if (!is_index(json_field(geometry, "template"), head.templates))
    return fmt::format("template is none of {}", head.templates);
  const Json& boundaries = json_field(geometry, "boundaries");
  if (!boundaries.is_array() || boundaries.size() != 1) return "boundaries of an instance is not one vertex";
  if (std::string what = check_nesting(boundaries, 1, vertices, false); !what.empty()) return "boundaries: " + what;
  return has_numbers(json_field(geometry, "transformationMatrix"), 16) ? "" : "transformationMatrix is not 16 numbers";
}

std::string check_type(const std::string_view type, const CityJsonHead& head) {
  if (type.empty()) return "type is missing";
  if (type[0] == '+' || is_listed(kFirstLevel, type) || is_listed(kSecondLevel, type)) return "";
  constexpr std::string_view kOld[] = {"IntBuildingInstallation", "IntBridgeInstallation", "IntTunnelInstallation"};
  return head.version != "2.0" && is_listed(kOld, type) ? "" : fmt::format("'{}' is no type of city object", type);
}

// When an object names others in a list, they must exist and name it in theirs.
std::string check_relatives(const Json& objects, const std::string& id, const char* list, const char* back) {
  const Json& names = json_field(objects[id], list);
  if (names.is_null()) return "";
  if (!names.is_array()) return fmt::format("{} is no list", list);
  for (const Json& name : names) {
    if (!name.is_string() || !objects.contains(name.get<std::string>()))
      return fmt::format("{} names '{}', which is no object", list, text_of(name));
    const Json& other = json_field(objects[name.get<std::string>()], back);
    if (!other.is_array() || std::find(other.begin(), other.end(), id) == other.end())
      return fmt::format("{} names '{}', whose {} do not name it", list, text_of(name), back);
  }
  return "";
}

std::string check_parts(const Json& object, const CityJsonHead& head) {
  if (const Json& attributes = json_field(object, "attributes"); !attributes.is_null() && !attributes.is_object())
    return "attributes is no object";
  const Json& extent = json_field(object, "geographicalExtent");
  if (!extent.is_null() && !has_numbers(extent, 6)) return "geographicalExtent is not six numbers";
  const Json& parents = json_field(object, "parents");
  const std::string_view type = text_of(json_field(object, "type"));
  if (head.version != "1.0" && is_listed(kSecondLevel, type) && (!parents.is_array() || parents.empty()))
    return fmt::format("a {} has no parents", type);
  const Json& geometry = json_field(object, "geometry");
  return geometry.is_null() || geometry.is_array() ? "" : "geometry is no list";
}

void check_object(const Json& objects, const std::string& id, std::size_t vertices, const CityJsonHead& head,
                  std::vector<FormatFault>& faults) {
  const Json& object = objects[id];
  if (!object.is_object()) return note(faults, id, "a city object is no object");
  note(faults, id, check_type(text_of(json_field(object, "type")), head));
  note(faults, id, check_parts(object, head));
  const bool group = json_field(object, "type") == "CityObjectGroup";
  note(faults, id, group ? "" : check_relatives(objects, id, "children", "parents"));
  note(faults, id, check_relatives(objects, id, "parents", "children"));
  const Json& geometries = json_field(object, "geometry");
  for (std::size_t i = 0; geometries.is_array() && i < geometries.size(); ++i)
    if (const std::string what = geometry_fault(geometries[i], vertices, head); !what.empty())
      note(faults, id, fmt::format("geometry {}: {}", i, what));
}

void check_templates(const Json& root, CityJsonHead& head, std::vector<FormatFault>& faults) {
  const Json& all = json_field(root, "geometry-templates");
  if (all.is_null()) return;
  const Json& templates = json_field(all, "templates");
  const Json& vertices = json_field(all, "vertices-templates");
  if (!templates.is_array()) return note(faults, "", "geometry-templates.templates is missing or no list");
  note(faults, "", check_vertices(vertices, false));
  for (std::size_t i = 0; i < templates.size(); ++i)
    if (const std::string what = geometry_fault(templates[i], vertices.size(), head); !what.empty())
      note(faults, "", fmt::format("geometry template {}: {}", i, what));
  head.templates = templates.size();
}

}  // namespace

std::vector<FormatFault> check_city_json_head(const Json& root, CityJsonHead& head) {
  std::vector<FormatFault> faults;
  const std::string_view version = text_of(json_field(root, "version"));
  constexpr std::string_view kVersions[] = {"1.0", "1.1", "2.0"};
  if (is_listed(kVersions, version))
    head.version = version;
  else
    note(faults, "", fmt::format("version '{}' is none of 1.0, 1.1, 2.0", version));
  if (root.contains("transform"))
    note(faults, "", check_transform(root["transform"]));
  else if (head.integer_vertices())
    note(faults, "", "transform is missing");
  note(faults, "", check_metadata(json_field(root, "metadata")));
  note(faults, "", check_reference_system(json_field(root, "metadata"), head));
  note(faults, "", check_vertices(json_field(root, "vertices"), head.integer_vertices()));
  check_templates(root, head, faults);
  if (!json_field(root, "CityObjects").is_object()) note(faults, "", "CityObjects is missing or no object");
  return faults;
}

std::vector<FormatFault> check_city_json_feature(const Json& root, const CityJsonHead& head) {
  std::vector<FormatFault> faults;
  const std::string id(text_of(json_field(root, "id")));
  const Json& objects = json_field(root, "CityObjects");
  if (!objects.is_object())
    note(faults, id, "CityObjects is missing or no object");
  else if (id.empty())
    note(faults, id, "a CityJSONFeature has no id");
  else if (!objects.contains(id))
    note(faults, id, "none of the feature's CityObjects has its id");
  note(faults, id, check_vertices(json_field(root, "vertices"), head.integer_vertices()));
  return faults;
}

std::vector<FormatFault> check_city_objects(const Json& objects, std::size_t vertices, const CityJsonHead& head) {
  std::vector<FormatFault> faults;
  if (!objects.is_object()) return faults;
  for (const auto& [id, object] : objects.items()) check_object(objects, id, vertices, head, faults);
  return faults;
}

std::string geometry_fault(const Json& geometry, std::size_t vertices, const CityJsonHead& head) {
  if (!geometry.is_object()) return "is no object";
  const std::string_view type = text_of(json_field(geometry, "type"));
  if (type == "GeometryInstance") return check_instance(geometry, vertices, head);
  const auto* const shape =
      std::find_if(std::begin(kShapes), std::end(kShapes), [&](const GeometryShape& s) { return s.type == type; });
  if (shape == std::end(kShapes)) return fmt::format("'{}' is no type of geometry", type);
  if (std::string what = check_lod(json_field(geometry, "lod"), head); !what.empty()) return what;
  const Json& boundaries = json_field(geometry, "boundaries");
  if (std::string what = check_nesting(boundaries, shape->depth, vertices, false); !what.empty())
    return "boundaries: " + what;
  const Json& semantics = json_field(geometry, "semantics");
  if (head.version == "1.0" && semantics.is_array()) return "";  // the form of drafts, which still occurs
  return check_semantics(semantics, boundaries, shape->depth);
}

}  // namespace ilot
