// SPDX-License-Identifier: Apache-2.0
// What stands on roofs, and trees and cars beside the houses of `roofs-wild`.
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/streets/objects/object_kinds.h"
#include "scan/unit.h"
#include "scan/wild/roofs/wild_roof_town.h"

namespace ilot::scan {
namespace {

// A position on a building in its own frame, in metres.
struct Footing {
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};

double roof_height(const RoofBuilding& building, double u, double v) {
  double height = -1e9;
  for (const Wing& wing : building.wings) {
    const double a = u / kUnit, b = v / kUnit;
    const bool over = a >= static_cast<double>(wing.rect.u0) && a <= static_cast<double>(wing.rect.u1) &&
                      b >= static_cast<double>(wing.rect.v0) && b <= static_cast<double>(wing.rect.v1);
    if (over) height = std::max(height, kUnit * height_mm(wing, a, b));
  }
  return height;
}

// Returns a solid over a rectangle in the frame of a building, between a level and a plane over it.
ConvexSolid solid_on(const RoofFrame& frame, const Footing& foot, double low, Vec3 normal, Vec3 through, double high) {
  ConvexSolid solid;
  const auto add = [&](Vec3 n, Vec3 p) {
    const Vec3 unit = frame.direction_to_town((1 / norm(n)) * n);
    solid.planes[solid.face_count++] = {unit, -dot(unit, frame.to_town(p))};
  };
  add(normal, through);
  add({-1, 0, 0}, {foot.u0, foot.v0, low});
  add({1, 0, 0}, {foot.u1, foot.v1, low});
  add({0, -1, 0}, {foot.u0, foot.v0, low});
  add({0, 1, 0}, {foot.u1, foot.v1, low});
  add({0, 0, -1}, {foot.u0, foot.v0, low});
  const Vec3 first = frame.to_town({foot.u0, foot.v0, low});
  solid.bounds = {first, first};
  for (const double u : {foot.u0, foot.u1})
    for (const double v : {foot.v0, foot.v1})
      for (const double z : {low, high}) solid.bounds.add(frame.to_town({u, v, z}));
  return solid;
}

class ExtrasBuilder {
 public:
  ExtrasBuilder(WildRoofTown& wild, Draws& draws) : wild_(wild), draws_(draws) {}

  void build() {
    for (std::uint32_t b = 0; b < wild_.town.buildings.size(); ++b) {
      Rng rng = draws_.random("roofs.extras", b);
      if (draws_.happens("roofs.chimneys", b)) chimneys(b, rng);
      if (draws_.happens("roofs.solar", b)) panels(b, rng);
      if (draws_.happens("roofs.equipment", b)) equipment(b, rng);
      if (draws_.happens("roofs.parapets", b)) parapets(b);
    }
  }

 private:
  void add(RoofExtraKind kind, std::uint32_t b, const ConvexSolid& solid, Material material) {
    wild_.extras.push_back({kind, b + 1, solid, material, 0});
  }

  // A box that stands on the roof and rises `above` its highest point there.
  void box(RoofExtraKind kind, std::uint32_t b, const Footing& foot, double above, Material material) {
    const RoofBuilding& building = wild_.town.buildings[b];
    double low = 1e9, high = -1e9;
    for (const double u : {foot.u0, foot.u1})
      for (const double v : {foot.v0, foot.v1}) {
        const double z = roof_height(building, u, v);
        low = std::min(low, z), high = std::max(high, z);
      }
    if (low < -1e8 || high - low > 3) return;
    const double top = high + above;
    add(kind, b, solid_on(building.frame, foot, low - 0.1, {0, 0, 1}, {foot.u0, foot.v0, top}, top), material);
  }

  Footing draw_footing(std::uint32_t b, Rng& rng, double length, double width) {
    const std::vector<Wing>& wings = wild_.town.buildings[b].wings;
    const GridRect& rect = wings[rng.below(wings.size())].rect;
    const double u =
        between(rng, kUnit * static_cast<double>(rect.u0) + 0.3, kUnit * static_cast<double>(rect.u1) - length - 0.3);
    const double v =
        between(rng, kUnit * static_cast<double>(rect.v0) + 0.3, kUnit * static_cast<double>(rect.v1) - width - 0.3);
    return {u, v, u + length, v + width};
  }

  void chimneys(std::uint32_t b, Rng& rng) {
    const auto count = 1 + rng.below(3);
    for (std::uint64_t i = 0; i < count; ++i)
      box(RoofExtraKind::chimney, b, draw_footing(b, rng, between(rng, 0.4, 1.4), between(rng, 0.4, 0.9)),
          between(rng, 0.3, 1.5), Material::brick);
  }

  void equipment(std::uint32_t b, Rng& rng) {
    const auto count = 1 + rng.below(5);
    for (std::uint64_t i = 0; i < count; ++i)
      box(RoofExtraKind::equipment, b, draw_footing(b, rng, between(rng, 0.6, 4), between(rng, 0.6, 3)),
          between(rng, 0.4, 2.6), Material::zinc);
  }

  // Panels of 1 m by 1.7 m in fields: 8 to 20 cm above a slope, or in tilted rows on what is flat.
  void panels(std::uint32_t b, Rng& rng) {
    const RoofBuilding& building = wild_.town.buildings[b];
    const double length = between(rng, 1.7, 9), width = between(rng, 1, 4);
    const Footing foot = draw_footing(b, rng, length, width);
    const auto z = [&](double u, double v) { return roof_height(building, u, v); };
    const Vec3 origin{foot.u0, foot.v0, z(foot.u0, foot.v0)};
    const double du = (z(foot.u1, foot.v0) - origin.z) / length, dv = (z(foot.u0, foot.v1) - origin.z) / width;
    const double lift = between(rng, 0.08, 0.2);
    const auto on_plane = [&](double u, double v) {
      return std::abs(z(u, v) - origin.z - du * (u - foot.u0) - dv * (v - foot.v0)) < 0.02;
    };
    if (!on_plane(foot.u1, foot.v1) || !on_plane((foot.u0 + foot.u1) / 2, (foot.v0 + foot.v1) / 2) ||
        std::abs(du) > 2 || std::abs(dv) > 2)
      return;
    if (std::abs(du) < 0.03 && std::abs(dv) < 0.03) {
      for (double v = foot.v0; v + 0.9 < foot.v1 + 2; v += 1.6) {
        const Footing row{foot.u0, v, foot.u1, v + 0.9};
        if (std::abs(z(row.u0, row.v1) - origin.z) > 0.05 || std::abs(z(row.u1, row.v1) - origin.z) > 0.05) break;
        add(RoofExtraKind::solar_panel, b,
            solid_on(building.frame, row, origin.z, {0, -0.25, 1}, {row.u0, row.v0, origin.z + lift},
                     origin.z + lift + 0.3),
            Material::glass);
      }
      return;
    }
    const double high = std::max({origin.z, z(foot.u1, foot.v0), z(foot.u0, foot.v1), z(foot.u1, foot.v1)}) + lift;
    add(RoofExtraKind::solar_panel, b,
        solid_on(building.frame, foot, high - 30, {-du, -dv, 1}, origin + Vec3{0, 0, lift}, high), Material::glass);
    // Only its upper face is seen: what is below it lies in the house.
    wild_.extras.back().solid.bounds.min.z = origin.z - 3;
  }

  // A wall of 30 to 110 cm around a flat first wing.
  void parapets(std::uint32_t b) {
    const RoofBuilding& building = wild_.town.buildings[b];
    const Wing& wing = building.wings[0];
    if (wing.planes.size() != 1 || wing.planes[0].a != 0 || wing.planes[0].b != 0) return;
    Rng rng = draws_.random("roofs.parapet", b);
    const double h = between(rng, 0.3, 1.1), d = between(rng, 0.15, 0.4);
    const double u0 = kUnit * static_cast<double>(wing.rect.u0), u1 = kUnit * static_cast<double>(wing.rect.u1);
    const double v0 = kUnit * static_cast<double>(wing.rect.v0), v1 = kUnit * static_cast<double>(wing.rect.v1);
    for (const Footing& foot : {Footing{u0, v0, u1, v0 + d}, Footing{u0, v1 - d, u1, v1}, Footing{u0, v0, u0 + d, v1},
                                Footing{u1 - d, v0, u1, v1}})
      box(RoofExtraKind::parapet, b, foot, h, building.wall);
  }

  WildRoofTown& wild_;
  Draws& draws_;
};

double nearest_building(const WildRoofTown& wild, double x, double y) {
  double nearest = 1e9;
  for (const RoofBuilding& building : wild.town.buildings)
    nearest = std::min(nearest, distance_to_building(building, x, y));
  return nearest;
}

// Draws a place in the built square, in the town.
Vec3 draw_place(const WildRoofTown& wild, Rng& rng) {
  const SinCos h = sin_cos_deg(wild.heading_deg);
  const double u = wild.width * (rng.uniform() - 0.5), v = wild.width * (rng.uniform() - 0.5);
  const double x = wild.town.area.x1 / 2 + u * h.cos - v * h.sin, y = wild.town.area.y1 / 2 + u * h.sin + v * h.cos;
  return {x, y, wild.town.ground.height(x, y)};
}

}  // namespace

void add_roof_extras(WildRoofTown& town, Draws& draws) {
  ExtrasBuilder(town, draws).build();
}

void add_wild_trees(WildRoofTown& wild, Draws& draws) {
  struct Form {
    std::string_view name;
    void (*make)(ObjectShape& shape, Rng& rng);
  };
  constexpr std::array<Form, 5> kForms{{{"ball_tree", make_ball_tree},
                                        {"column_tree", make_column_tree},
                                        {"cone_tree", make_cone_tree},
                                        {"spreading_tree", make_spreading_tree},
                                        {"shrub", make_shrub}}};
  const double area = wild.width * wild.width;
  const auto wanted = static_cast<std::uint64_t>(draws.number("roofs.trees") * area / 1e4);
  const double at_houses = draws.number("roofs.trees_at_houses");
  for (std::uint64_t i = 0; i < wanted; ++i) {
    Rng rng = draws.random("roofs.tree", i);
    const bool near = rng.uniform() < at_houses;
    const Form& form = kForms[rng.below(kForms.size())];
    ObjectShape shape;
    form.make(shape, rng);
    Vec3 base;
    double apart = 0;
    bool placed_well = false;
    for (int attempt = 0; attempt < 30 && !placed_well; ++attempt) {
      base = draw_place(wild, rng);
      apart = nearest_building(wild, base.x, base.y);
      placed_well = near ? apart > 0.3 && apart < 2.5 : apart > 2.5;
    }
    if (!placed_well) continue;
    double top = 0, wide = 0;
    for (const Crown& leaf : shape.leaves) {
      wild.town.crowns.push_back({base + leaf.centre, leaf.radii});
      wild.tree_of_crown.push_back(static_cast<std::uint32_t>(wild.trees.size()));
      top = std::max(top, leaf.centre.z + leaf.radii.z);
      wide = std::max(wide, std::sqrt(leaf.centre.x * leaf.centre.x + leaf.centre.y * leaf.centre.y) + leaf.radii.x);
    }
    wild.trees.push_back({{static_cast<std::uint32_t>(wild.trees.size() + 1), std::string(form.name), base, top,
                           shape.crown_base, wide, shape.trunk_radius, 0, std::nullopt},
                          near});
  }
}

void add_cars(WildRoofTown& wild, Draws& draws) {
  const auto wanted = static_cast<std::uint64_t>(draws.number("roofs.cars") * wild.width * wild.width / 1e4);
  for (std::uint64_t i = 0; i < wanted; ++i) {
    Rng rng = draws.random("roofs.car", i);
    const Vec3 base = draw_place(wild, rng);
    if (nearest_building(wild, base.x, base.y) < 2.6) continue;
    const RoofFrame frame{base.x, base.y,
                          sin_cos_deg(std::remainder(
                              wild.heading_deg + 90 * static_cast<double>(rng.below(2)) + between(rng, -5, 5), 360.0))};
    const double l = between(rng, 3.5, 5.4) / 2, w = between(rng, 1.65, 2.05) / 2, h = between(rng, 1.4, 2.4),
                 z = base.z;
    const std::uint64_t key = draws.random("roofs.car_there", i).next();
    wild.cars.push_back({RoofExtraKind::car, 0,
                         solid_on(frame, {-l, -w, l, w}, z + 0.2, {0, 0, 1}, {0, 0, z + 0.62 * h}, z + 0.62 * h),
                         Material::car_paint, key});
    wild.cars.push_back(
        {RoofExtraKind::car, 0,
         solid_on(frame, {-0.85 * l, -0.85 * w, 0.45 * l, 0.85 * w}, z + 0.3, {0, 0, 1}, {0, 0, z + h}, z + h),
         Material::car_paint, key});
  }
}

}  // namespace ilot::scan
