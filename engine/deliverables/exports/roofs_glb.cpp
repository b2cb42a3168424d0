// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/roofs_glb.h"

#include <cmath>

#include "engine/deliverables/exports/flat_mesh.h"
#include "engine/model/building_geometry.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

Json attributes_json(const BuildingModel& model) {
  Json json{{"id", model.id}};
  for (const auto& [name, value] : model.attributes) std::visit([&](const auto& v) { json[name] = v; }, value);
  json["id"] = model.id;  // not a further attribute of a footprint that has this name
  return json;
}

Json frame_json(const ExportFrame& frame) {
  return {{"crs", frame.crs_name},
          {"offset", {frame.origin.x, frame.origin.y, frame.origin.z}},
          {"metres_per_unit", frame.metres_per_unit}};
}

}  // namespace

RoofsGlb::RoofsGlb(const std::filesystem::path& path, const ExportFrame& frame) : path_(path), frame_(frame) {
  glb_.json = glb_start();
  glb_.json["asset"]["extras"] = frame_json(frame);
  glb_.json["scene"] = 0;
  glb_.json["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
  glb_.json["nodes"] = Json::array({{{"name", "roofs"},
                                     {"rotation", z_up()},
                                     {"translation", y_up_place(frame.metres_per_unit * frame.origin)},
                                     {"extras", frame_json(frame)}}});
  glb_.json["meshes"] = Json::array();
}

void RoofsGlb::add(const BuildingModel& model) {
  const Building* building = finest_solid(model.levels);
  if (!building) return;
  const BuildingMesh mesh = building_mesh(*building);
  if (mesh.triangles.empty()) return;
  const Vec3 first = frame_.at(mesh.vertices[0]);
  const Vec3 anchor{std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  FlatMesh flat;
  add_flat(flat, *building, mesh, [&](Vec3 v) { return frame_.at(v) - anchor; });
  Json &meshes = glb_.json["meshes"], &nodes = glb_.json["nodes"];
  nodes[0]["children"].push_back(nodes.size());
  nodes.push_back({{"name", model.id},
                   {"mesh", meshes.size()},
                   {"translation", {anchor.x, anchor.y, anchor.z}},
                   {"extras", attributes_json(model)}});
  meshes.push_back({{"primitives", flat_primitives(glb_, flat)}});
}

void RoofsGlb::finish() {
  if (glb_.json["meshes"].empty()) glb_.json.erase("meshes");
  write_whole_file(path_, glb_.file(path_.string()));
}

}  // namespace ilot
