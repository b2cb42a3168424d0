// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/deliverables/exports/tile_content.h"
#include "engine/deliverables/solids/building_fields.h"
#include "engine/model/building_geometry.h"
#include "engine/model/point_label.h"

namespace ilot {
namespace {

PropertyClass building_class() {
  PropertyClass c{"building", {{"id", PropertyType::text, "", "of the building"}}};
  for (const BuildingField& f : building_fields())
    c.properties.push_back({f.name,
                            f.kind == FieldKind::real    ? PropertyType::real
                            : f.kind == FieldKind::whole ? PropertyType::whole
                                                         : PropertyType::text,
                            f.unit, f.meaning});
  return c;
}

// The attribute under its own name or under one of roofer's style, in the type of the column.
PropertyValue value_of(const BuildingModel& model, const BuildingField& field) {
  const std::vector<std::string> names = names_of(field);
  if (field.kind == FieldKind::text) {
    for (const std::string& name : names)
      if (const auto text = model.text(name)) return *text;
    return std::string();
  }
  std::optional<double> number;
  for (auto name = names.begin(); !number && name != names.end(); ++name) number = model.number(*name);
  if (field.kind == FieldKind::real) return number.value_or(kNoReal);
  return static_cast<std::int64_t>(number.value_or(double{kNoWhole}));
}

// A box with its lower side at the base, as wide, long and high as the object.
Building box_of(const StreetObject& o, double metres_per_unit) {
  const double angle = o.heading_deg * std::numbers::pi / 180, unit = 1 / metres_per_unit;
  const Vec3 along = (0.5 * unit * o.length_m) * Vec3{std::cos(angle), std::sin(angle), 0},
             across = (0.5 * unit * o.width_m) * Vec3{-std::sin(angle), std::cos(angle), 0},
             foot{o.middle.x, o.middle.y, o.base.z};
  Building box;
  for (const double z : {0.0, unit * o.height_m})
    for (const Vec3& corner :
         {foot - along - across, foot + along - across, foot + along + across, foot - along + across})
      box.vertices.push_back(corner + Vec3{0, 0, z});
  box.surfaces = {{SurfaceKind::roof, 0, {{4, 5, 6, 7}}}, {SurfaceKind::ground, 0, {{3, 2, 1, 0}}}};
  for (std::uint32_t i = 0; i < 4; ++i)
    box.surfaces.push_back({SurfaceKind::wall, 0, {{i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4}}});
  return box;
}

}  // namespace

const std::vector<PropertyClass>& tile_classes() {
  static const std::vector<PropertyClass> classes{
      building_class(),
      {"face",
       {{"surface", PropertyType::surface, "", "roof, wall or ground"},
        {"building", PropertyType::text, "", "id of its building"},
        {"plane_id", PropertyType::whole, "", "of roofs"},
        {"area_m2", PropertyType::real, "m2", "in space, holes taken off"},
        {"slope_deg", PropertyType::real, "deg", "between the face and the level"},
        {"azimuth_deg", PropertyType::real, "deg", "where it looks, clockwise from north"}}},
      {"object",
       {{"object_id", PropertyType::whole, "", "as in streets/objects.gpkg"},
        {"class", PropertyType::text, "", "car, van, two_wheeler, pedestrian, lamppost, sign ... (docs/outputs.md)"},
        {"probability", PropertyType::real, "", "of that class"},
        {"height_m", PropertyType::real, "m", "above the ground around it"},
        {"length_m", PropertyType::real, "m", "of its rectangle"},
        {"width_m", PropertyType::real, "m", "of its rectangle"},
        {"points", PropertyType::whole, "", "above the ground in its pixels"}}}};
  return classes;
}

TileModel tile_model(const BuildingModel& building, const Building& solid, const Placement& placement,
                     double metres_per_unit) {
  TileModel model{false, {}, building_mesh(solid), {building.id}, {}};
  for (const BuildingField& field : building_fields()) model.row.push_back(value_of(building, field));
  for (const BuildingSurface& surface : solid.surfaces) {
    const SurfaceShape shape = surface_shape(solid, surface, metres_per_unit);
    model.faces.push_back({std::int64_t{static_cast<std::uint8_t>(surface.kind)}, building.id,
                           surface.plane_id > 0 ? std::int64_t{surface.plane_id} : kNoWhole, shape.area_m2,
                           shape.slope_deg, shape.azimuth_deg < 0 ? kNoReal : shape.azimuth_deg});
    model.shape.surfaces.push_back({surface.kind, surface.plane_id, {}});
  }
  placement.apply(model.mesh.vertices);
  return model;
}

TileModel tile_model(const StreetObject& object, const Placement& placement, double metres_per_unit) {
  const Building box = box_of(object, metres_per_unit);
  TileModel model{true,
                  {},
                  building_mesh(box),
                  {std::int64_t{object.id}, object.class_name, object.probability, object.height_m, object.length_m,
                   object.width_m, static_cast<std::int64_t>(object.points)},
                  {}};
  model.shape.surfaces = box.surfaces;
  placement.apply(model.mesh.vertices);
  return model;
}

}  // namespace ilot
