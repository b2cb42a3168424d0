// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_model.h"

#include <array>
#include <cmath>
#include <map>

#include "scan/streets/street_houses.h"

namespace ilot::scan {
namespace {

constexpr double kGroundDepth = 0.5;  // metres below the surface that the boxes of the ground reach
constexpr double kBeyond = 25;        // metres of road beyond the pavements, across

Plane ground_plane(const Street& street, double lift) {
  const double length = std::sqrt(1 + street.slope * street.slope);
  return {{-street.slope / length, 0, 1 / length}, -(street.base + lift) / length};
}

std::vector<Vec3> ground_ring(const Street& street, double s0, double s1, double t0, double t1, double lift) {
  const auto corner = [&](double s, double t) { return Vec3{s, t, street.road_height(s) + lift}; };
  return {corner(s0, t0), corner(s1, t0), corner(s1, t1), corner(s0, t1)};
}

Box3<Vec3> ground_bounds(const Street& street, double s0, double s1, double t0, double t1, double lift) {
  return {{s0, t0, street.road_height(s0) - kGroundDepth}, {s1, t1, street.road_height(s1) + lift}};
}

void add_road(StreetModel& model, const Street& street) {
  const double s0 = -kBeyond, s1 = street.length + kBeyond, t1 = kCrossStreet + kBeyond;
  const Plane plane = ground_plane(street, 0);
  const std::uint32_t id = add_plane(model, "ground", plane, ground_ring(street, s0, s1, -t1, t1, 0)).id;
  Solid road;
  road.planes[road.plane_count++] = plane;
  road.surfaces.fill(
      model.scene.add_surface({static_cast<std::uint8_t>(StreetClass::ground), id, 0, Material::asphalt}));
  road.bounds = ground_bounds(street, s0, s1, -t1, t1, 0);
  model.scene.parts.push_back(road);
}

// Adds a slab. Its upright sides are the kerbs.
void add_pavement(StreetModel& model, const Street& street, const StreetBlock& block, int side) {
  const double s0 = block.from - kCorner, s1 = block.to + kCorner;
  const double t0 = side > 0 ? kHalfRoad : -kCrossStreet, t1 = side > 0 ? kCrossStreet : -kHalfRoad;
  const Plane top = ground_plane(street, kKerb);
  const std::uint32_t id = add_plane(model, "ground", top, ground_ring(street, s0, s1, t0, t1, kKerb)).id;
  Solid slab;
  for (const Plane& plane :
       {top, Plane{{1, 0, 0}, -s1}, Plane{{-1, 0, 0}, s0}, Plane{{0, 1, 0}, -t1}, Plane{{0, -1, 0}, t0}})
    slab.planes[slab.plane_count++] = plane;
  const auto ground = static_cast<std::uint8_t>(StreetClass::ground);
  slab.surfaces.fill(model.scene.add_surface({ground, 0, 0, Material::limestone}));
  slab.surfaces[0] = model.scene.add_surface({ground, id, 0, Material::paving});
  slab.bounds = ground_bounds(street, s0, s1, t0, t1, kKerb);
  model.scene.parts.push_back(slab);
}

void add_tree(StreetModel& model, const StreetTree& tree) {
  const SurfaceId bark =
      model.scene.add_surface({static_cast<std::uint8_t>(StreetClass::vegetation), 0, 0, Material::wood});
  model.scene.parts.push_back(
      cylinder(tree.foot - Vec3{0, 0, 0.2}, {0, 0, 1}, tree.crown.centre.z - tree.foot.z, 0.14, bark));
  model.crowns.push_back(tree.crown);
}

void add_object(StreetModel& model, const StreetObject& object) {
  std::map<SurfaceId, SurfaceId> surface_of;  // by material
  const auto true_class = static_cast<std::uint8_t>(class_of(object.artefact_class));
  for (const Solid& local : object.shape.solids) {
    Solid solid = placed(local, object.pose);
    for (SurfaceId& surface : solid.surfaces) {
      const auto [entry, fresh] = surface_of.try_emplace(surface, 0);
      if (fresh) entry->second = model.scene.add_surface({true_class, 0, object.id, static_cast<Material>(surface)});
      surface = entry->second;
    }
    model.scene.parts.push_back(solid);
  }
}

}  // namespace

StreetClass class_of(ArtefactClass artefact_class) {
  switch (artefact_class) {
    case ArtefactClass::car:
      return StreetClass::car;
    case ArtefactClass::lamppost:
      return StreetClass::lamppost;
    case ArtefactClass::pedestrian:
      return StreetClass::pedestrian;
    case ArtefactClass::other:
      return StreetClass::other;
  }
  return StreetClass::other;
}

const char* name_of(StreetClass street_class) {
  constexpr std::array kNames{"", "ground", "facade", "car", "lamppost", "pedestrian", "other", "vegetation", "roof"};
  static_assert(kNames.size() == kStreetClasses);
  return kNames[static_cast<std::size_t>(street_class)];
}

std::map<int, std::string> street_class_names() {
  std::map<int, std::string> names;
  for (std::size_t value = 1; value < kStreetClasses; ++value)
    names[static_cast<int>(value)] = name_of(static_cast<StreetClass>(value));
  return names;
}

std::uint8_t las_class(StreetClass street_class) {
  switch (street_class) {
    case StreetClass::ground:
      return 2;
    case StreetClass::facade:
    case StreetClass::roof:
      return 6;
    case StreetClass::vegetation:
      return 5;
    default:
      return 1;
  }
}

StreetModel build_street_model(const Street& street, const std::vector<StreetObject>& objects) {
  StreetModel model;
  add_road(model, street);
  for (const StreetBlock& block : street.blocks)
    for (int side : {1, -1}) add_pavement(model, street, block, side);
  for (const StreetHouse& house : street.houses) add_house(model, street, house);
  for (const StreetTree& tree : street.trees) add_tree(model, tree);
  for (const StreetObject& object : objects) add_object(model, object);
  return model;
}

}  // namespace ilot::scan
