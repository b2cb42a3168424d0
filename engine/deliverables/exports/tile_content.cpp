// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/tile_content.h"

#include <cmath>

#include "engine/deliverables/exports/flat_mesh.h"
#include "kernels/geometry/box3.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kBuildings = 0, kFaces = 1, kObjects = 2;  // of tile_classes()
constexpr std::size_t kObjectMaterial = 3;

// One mesh of a tile: the models of one kind together, with the features of each vertex.
struct Part {
  FlatMesh flat;
  std::vector<float> model, face;  // of each vertex: float32 counts up to 2^24, far beyond a tile
  std::vector<PropertyRow> models, faces;
};

Vec3 anchor_of(const std::vector<const TileModel*>& models) {
  Box3<Vec3> box = Box3<Vec3>::none();
  for (const TileModel* m : models)
    for (const Vec3& v : m->mesh.vertices) box.add(v);
  const Vec3 middle = 0.5 * (box.min + box.max);
  return {std::floor(middle.x), std::floor(middle.y), std::floor(middle.z)};
}

void add_model(Part& part, const TileModel& model, Vec3 anchor) {
  const auto faces = static_cast<float>(part.faces.size());
  add_flat(
      part.flat, model.shape, model.mesh, [&](Vec3 v) { return v - anchor; },
      [&](std::uint32_t surface, std::uint32_t first, std::uint32_t end) {
        part.face.insert(part.face.end(), end - first, faces + static_cast<float>(surface));
        part.model.insert(part.model.end(), end - first, static_cast<float>(part.models.size()));
      });
  part.models.push_back(model.row);
  part.faces.insert(part.faces.end(), model.faces.begin(), model.faces.end());
}

Json feature_ids(std::size_t attribute, std::size_t count, std::size_t table, const char* label) {
  return {{"featureCount", count}, {"attribute", attribute}, {"propertyTable", table}, {"label", label}};
}

// Adds the tables of the part and a node with its mesh.
void add_part(Glb& glb, const Part& part, bool objects, Vec3 anchor) {
  if (part.models.empty()) return;
  Json& tables = glb.json["extensions"]["EXT_structural_metadata"]["propertyTables"];
  Json ids = Json::array(), attributes{{"_FEATURE_ID_0", glb.add_scalars(part.model)}};
  const auto add_table = [&](std::size_t number, const std::vector<PropertyRow>& rows) {
    const PropertyClass& of = tile_classes()[number];
    ids.push_back(feature_ids(ids.size(), rows.size(), tables.size(), of.name.c_str()));
    tables.push_back(property_table(glb, of, rows));
  };
  add_table(objects ? kObjects : kBuildings, part.models);
  if (!objects) {
    add_table(kFaces, part.faces);
    attributes["_FEATURE_ID_1"] = glb.add_scalars(part.face);
  }
  Json primitives = flat_primitives(glb, part.flat, attributes);
  for (Json& primitive : primitives) {
    if (objects) primitive["material"] = kObjectMaterial;
    primitive["extensions"]["EXT_mesh_features"]["featureIds"] = ids;
  }
  glb.json["nodes"].push_back({{"name", objects ? "objects" : "buildings"},
                               {"mesh", glb.json["meshes"].size()},
                               {"rotation", z_up()},
                               {"translation", y_up_place(anchor)}});
  glb.json["meshes"].push_back({{"primitives", primitives}});
  glb.json["scenes"][0]["nodes"].push_back(glb.json["nodes"].size() - 1);
}

}  // namespace

std::string tile_content(const std::vector<const TileModel*>& models, const std::string& name) {
  Glb glb;
  glb.json = glb_start();
  glb.json["materials"].push_back(
      {{"name", "object"},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.16, 0.42, 0.70, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}}});
  glb.json["extensionsUsed"] = {"EXT_mesh_features", "EXT_structural_metadata"};
  glb.json["scene"] = 0;
  glb.json["scenes"] = Json::array({{{"nodes", Json::array()}}});
  glb.json["nodes"] = glb.json["meshes"] = Json::array();
  glb.json["extensions"]["EXT_structural_metadata"] = metadata_start(tile_classes());
  const Vec3 anchor = anchor_of(models);
  Part buildings, objects;
  for (const TileModel* model : models) add_model(model->is_object ? objects : buildings, *model, anchor);
  add_part(glb, buildings, false, anchor);
  add_part(glb, objects, true, anchor);
  return glb.file(name);
}

}  // namespace ilot
