// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/city_json_solids.h"

#include <fmt/format.h>

#include "engine/deliverables/solids/json_parts.h"
#include "engine/error.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kTemplateVertices = std::uint64_t{1} << 40;  // their numbers follow those of the file

bool is_vector(const Json& list) {
  return list.is_array() && list.size() >= 3 && list[0].is_number() && list[1].is_number() && list[2].is_number();
}

Vec3 vector_of(const Json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

std::string lod_text(const Json& geometry) {
  const Json& lod = json_field(geometry, "lod");
  if (lod.is_string()) return lod.get<std::string>();
  return lod.is_number() ? fmt::format("{}", lod.get<double>()) : "";
}

// Converts nested lists to nested vectors; numbers are looked up.
template <class Number>
SolidShell shell_of(const Json& faces, const Number& number) {
  SolidShell shell;
  for (const Json& rings : faces) {
    shell.emplace_back();
    for (const Json& ring : rings) {
      auto& corners = shell.back().rings.emplace_back();
      for (const Json& corner : ring) corners.push_back(number(corner.get<std::uint64_t>()));
    }
  }
  return shell;
}

template <class Number>
SolidShells shells_of(const Json& shells, const Number& number) {
  SolidShells out;
  for (const Json& shell : shells) out.push_back(shell_of(shell, number));
  return out;
}

// Returns false for a kind without surfaces.
template <class Number>
bool fill_primitive(const Json& geometry, const Number& number, Primitive& primitive) {
  const Json& type = json_field(geometry, "type");
  const Json& boundaries = json_field(geometry, "boundaries");
  if (type == "MultiSurface" || type == "CompositeSurface") {
    primitive.kind = type == "MultiSurface" ? PrimitiveKind::multi_surface : PrimitiveKind::composite_surface;
    primitive.solids.push_back({shell_of(boundaries, number)});
  } else if (type == "Solid") {
    primitive.solids.push_back(shells_of(boundaries, number));
  } else if (type == "MultiSolid" || type == "CompositeSolid") {
    primitive.kind = type == "MultiSolid" ? PrimitiveKind::multi_solid : PrimitiveKind::composite_solid;
    for (const Json& shells : boundaries) primitive.solids.push_back(shells_of(shells, number));
  } else {
    return false;
  }
  return true;
}

bool is_part_of_a_building(const Json& objects, const Json& object) {
  if (json_field(object, "type") != "BuildingPart") return false;
  const Json& parents = json_field(object, "parents");
  return parents.is_array() && !parents.empty() && parents[0].is_string() &&
         objects.contains(parents[0].get<std::string>());
}

}  // namespace

void CityJsonSolids::give(const std::vector<FormatFault>& faults) const {
  for (const FormatFault& fault : faults) sink_.fault(fault);
}

void CityJsonSolids::text(std::string_view text, std::uint64_t line) {
  const std::string place = line ? fmt::format("{}:{}", name_, line) : name_;
  const Json root = parse_json(text, place);
  const Json& type = json_field(root, "type");
  if (type == "CityJSON") {
    give(check_city_json_head(root, head_));
    const Json& transform = json_field(root, "transform");
    if (is_vector(json_field(transform, "scale")) && is_vector(json_field(transform, "translate"))) {
      scale_ = vector_of(transform["scale"]);
      translate_ = vector_of(transform["translate"]);
    }
    templates_ = json_field(root, "geometry-templates");
    any_head_ = true;
  } else if (type == "CityJSONFeature") {
    give(check_city_json_feature(root, head_));
    if (!any_head_) sink_.fault({"", "a CityJSONFeature comes before the CityJSON object that says its transform"});
  } else {
    throw Error(place + ": neither a CityJSON object nor a CityJSONFeature");
  }
  add_objects(root);
}

void CityJsonSolids::finish() {
  if (!any_head_) sink_.fault({"", "no CityJSON object"});
}

void CityJsonSolids::add_objects(const Json& root) {
  const Json& objects = json_field(root, "CityObjects");
  const Json& vertices = json_field(root, "vertices");
  give(check_city_objects(objects, vertices.is_array() ? vertices.size() : 0, head_));
  if (!objects.is_object()) return;
  for (const auto& [id, object] : objects.items()) {
    if (!object.is_object() || is_part_of_a_building(objects, object)) continue;
    const Json& type = json_field(object, "type");
    CityObject made{id, type.is_string() ? type.get<std::string>() : "", {}, {}};
    local_.clear();
    add_geometries(objects, id, made, vertices);
    const Json& children = json_field(object, "children");
    if (type == "Building" && children.is_array())
      for (const Json& child : children)
        if (child.is_string() && child != id && objects.contains(child.get<std::string>())) {
          made.parts.push_back(child.get<std::string>());
          add_geometries(objects, made.parts.back(), made, vertices);
        }
    sink_.object(made);
  }
}

void CityJsonSolids::add_geometries(const Json& objects, const std::string& id, CityObject& object,
                                    const Json& vertices) {
  const Json& geometries = json_field(objects[id], "geometry");
  if (!geometries.is_array()) return;
  for (const Json& geometry : geometries)
    if (geometry_fault(geometry, vertices.size(), head_).empty()) add_geometry(geometry, id, object, vertices);
}

void CityJsonSolids::add_geometry(const Json& geometry, const std::string& owner, CityObject& object,
                                  const Json& vertices) {
  const bool instance = json_field(geometry, "type") == "GeometryInstance";
  const Json& source = instance ? templates_["templates"][geometry["template"].get<std::size_t>()] : geometry;
  const Json& points = instance ? json_field(templates_, "vertices-templates") : vertices;
  if (instance && !geometry_fault(source, points.size(), head_).empty()) return;
  const auto number = [&](std::uint64_t i) {
    const auto [entry, fresh] = local_.try_emplace(instance ? kTemplateVertices + i : i, object.vertices.size());
    if (!fresh) return entry->second;
    Vec3 p = is_vector(points[i]) ? vector_of(points[i]) : Vec3{};
    if (!instance) p = {p.x * scale_.x + translate_.x, p.y * scale_.y + translate_.y, p.z * scale_.z + translate_.z};
    object.vertices.push_back(p);
    return entry->second;
  };
  Primitive primitive{PrimitiveKind::solid, lod_text(source), owner, {}};
  if (fill_primitive(source, number, primitive)) object.primitives.push_back(std::move(primitive));
}

}  // namespace ilot
