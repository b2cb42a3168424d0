// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/roofs_gpkg.h"

#include <cmath>

#include "engine/deliverables/layers/gpkg_file.h"

namespace ilot {
namespace {

OGRPolygon polygon_of(const Building& building, const BuildingSurface& surface, bool flat) {
  OGRPolygon polygon;
  bool hole = false;
  if (!flat) polygon.set3D(true);
  for (const auto& ring : surface.rings) {
    OGRLinearRing closed;
    for (const std::uint32_t i : ring) {
      const Vec3& p = building.vertices[i];
      flat ? closed.addPoint(p.x, p.y) : closed.addPoint(p.x, p.y, p.z);
    }
    closed.closeRings();
    if (flat && closed.isClockwise() != hole) closed.reversePoints();  // the floor of a solid faces down
    hole = true;
    polygon.addRing(&closed);
  }
  return polygon;
}

// Returns the ground of the first level that has one.
OGRMultiPolygon outline_of(std::span<const Building> levels) {
  OGRMultiPolygon outline;
  for (const Building& level : levels) {
    for (const BuildingSurface& surface : level.surfaces) {
      if (surface.kind != SurfaceKind::ground) continue;
      OGRPolygon part = polygon_of(level, surface, true);
      outline.addGeometry(&part);
    }
    if (!outline.IsEmpty()) break;
  }
  return outline;
}

void set(OGRFeature& feature, const std::string& name, const AttributeValue& value) {
  const int field = feature.GetFieldIndex(name.c_str());
  if (field < 0) return;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) feature.SetField(field, static_cast<GIntBig>(*whole));
  if (const auto* text = std::get_if<std::string>(&value)) feature.SetField(field, text->c_str());
  if (const auto* truth = std::get_if<bool>(&value)) feature.SetField(field, *truth ? 1 : 0);
  if (const auto* real = std::get_if<double>(&value); real && std::isfinite(*real)) feature.SetField(field, *real);
}

void add_field(OGRLayer& layer, const std::string& name, FieldKind kind) {
  constexpr OGRFieldType kTypes[] = {OFTInteger64, OFTReal, OFTString, OFTInteger};
  GpkgFile::add_field(layer, name.c_str(), kTypes[static_cast<int>(kind)],
                      kind == FieldKind::truth ? OFSTBoolean : OFSTNone);
}

}  // namespace

struct RoofsGpkg::Layers {
  GpkgFile file;
  AttributeStyle style;
  double metres_per_unit;
  OGRLayer& buildings;
  OGRLayer& faces;

  Layers(const std::filesystem::path& path, const Crs& crs, AttributeStyle named, double metres, const Columns& further)
      : file(path),
        style(named),
        metres_per_unit(metres),
        buildings(file.add_layer("buildings", wkbMultiPolygon, crs)),
        faces(file.add_layer("roof_faces", wkbPolygon25D, crs)) {
    add_field(buildings, "id", FieldKind::text);
    for (const auto& [name, kind] : attribute_columns(style)) add_field(buildings, name, kind);
    for (const auto& [name, kind] : further) add_field(buildings, name, kind);
    add_field(faces, "building", FieldKind::text);
    add_field(faces, "lod", FieldKind::text);
    for (const auto& [name, kind] : face_columns(style)) add_field(faces, name, kind);
    file.set_style(buildings, style_of_buildings());
    file.set_style(faces, style_of_roof_faces());
  }

  void add_faces(const Building& building) {
    for (const BuildingSurface& surface : building.surfaces) {
      if (surface.kind != SurfaceKind::roof) continue;
      OGRFeature feature(faces.GetLayerDefn());
      set(feature, "building", building.id);
      set(feature, "lod", building.lod);
      set(feature, "plane_id", std::int64_t{surface.plane_id});
      for (const auto& [name, value] : face_attributes(building, surface, style, metres_per_unit))
        set(feature, name, value);
      OGRPolygon polygon = polygon_of(building, surface, false);
      feature.SetGeometry(&polygon);
      file.add(faces, feature);
    }
  }
};

RoofsGpkg::RoofsGpkg(const std::filesystem::path& path, const Crs& crs, AttributeStyle style, double metres_per_unit,
                     const Columns& further)
    : layers_(std::make_unique<Layers>(path, crs, style, metres_per_unit, further)) {}

RoofsGpkg::~RoofsGpkg() = default;

void RoofsGpkg::add(std::span<const Building> levels) {
  OGRFeature feature(layers_->buildings.GetLayerDefn());
  set(feature, "id", levels[0].id);
  for (const auto& [name, value] : styled_attributes(levels[0].attributes, layers_->style)) set(feature, name, value);
  OGRMultiPolygon outline = outline_of(levels);
  feature.SetGeometry(&outline);
  layers_->file.add(layers_->buildings, feature);
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    if (level->surfaces.empty()) continue;
    layers_->add_faces(*level);
    return;
  }
}

void RoofsGpkg::finish() {
  layers_->file.finish();
}

}  // namespace ilot
