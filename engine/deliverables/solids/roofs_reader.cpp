// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/roofs_reader.h"

#include <fstream>
#include <string>

#include "engine/deliverables/solids/json_parts.h"
#include "engine/error.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

struct VertexTransform {
  double step = 1;
  Vec3 origin;
};

VertexTransform steps_of(const Json& head) {
  const Json& transform = head.at("transform");
  const Json& scale = transform.at("scale");
  const Json& shift = transform.at("translate");
  return {scale.at(0).get<double>(), {shift.at(0), shift.at(1), shift.at(2)}};
}

AttributeValue value_of(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return value.dump();  // lists of ids
}

SurfaceKind kind_of_surface(const std::string& type) {
  if (type == "RoofSurface") return SurfaceKind::roof;
  return type == "WallSurface" ? SurfaceKind::wall : SurfaceKind::ground;
}

// Returns the surfaces of the outer shell, or of a flat outline.
std::vector<BuildingSurface> surfaces_of(const Json& geometry, std::size_t vertices, const std::string& place) {
  const bool solid = geometry.at("type") == "Solid";
  const Json& faces = solid ? geometry.at("boundaries").at(0) : geometry.at("boundaries");
  const Json& semantics = geometry.at("semantics");
  const Json& values = solid ? semantics.at("values").at(0) : semantics.at("values");
  std::vector<BuildingSurface> surfaces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Json& said = semantics.at("surfaces").at(values.at(i).get<std::size_t>());
    BuildingSurface surface{kind_of_surface(said.at("type")), said.value("plane_id", 0u), {}};
    for (const Json& ring : faces[i]) surface.rings.push_back(ring.get<std::vector<std::uint32_t>>());
    for (const auto& ring : surface.rings)
      for (const std::uint32_t v : ring)
        if (v >= vertices) throw Error(place + ": a face names a vertex that is none");
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

BuildingModel model_of(const Json& feature, const VertexTransform& steps, const std::string& place) {
  BuildingModel model;
  model.id = feature.at("id");
  const Json& object = feature.at("CityObjects").at(model.id);
  for (const auto& [name, value] : object.at("attributes").items())
    if (!value.is_null()) model.attributes.emplace_back(name, value_of(value));
  std::vector<Vec3> vertices;
  for (const Json& v : feature.at("vertices"))
    vertices.push_back(steps.origin + steps.step * Vec3{v.at(0), v.at(1), v.at(2)});
  for (const Json& geometry : object.at("geometry")) {
    Building level;
    level.id = model.id;
    level.lod = geometry.at("lod");
    level.vertices = vertices;
    level.surfaces = surfaces_of(geometry, vertices.size(), place);
    model.levels.push_back(std::move(level));
  }
  return model;
}

}  // namespace

void for_each_roof(const std::filesystem::path& path, const std::function<void(const BuildingModel&)>& use) {
  std::ifstream file(path);
  std::string text;
  VertexTransform steps;
  for (std::size_t line = 1; std::getline(file, text); ++line) {
    const std::string place = path.string() + ":" + std::to_string(line);
    try {
      const Json json = parse_json(text, place);
      if (line == 1) steps = steps_of(json);
      if (line > 1) use(model_of(json, steps, place));
    } catch (const Json::exception& fault) {
      throw Error(place + ": is not as a run writes it: " + fault.what());
    }
  }
  if (!file.eof()) throw Error(path.string() + ": cannot be read");
}

std::vector<BuildingModel> read_roofs_sequence(const std::filesystem::path& path) {
  std::vector<BuildingModel> models;
  for_each_roof(path, [&](const BuildingModel& model) { models.push_back(model); });
  return models;
}

}  // namespace ilot
