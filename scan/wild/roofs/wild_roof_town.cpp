// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/roofs/wild_roof_town.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan/roofs/roof_neighbours.h"
#include "scan/roofs/roof_styles.h"
#include "scan/roofs/roof_wings.h"
#include "scan/unit.h"
#include "scan/wild/roofs/wild_roof_forms.h"

namespace ilot::scan {
namespace {

constexpr double kLeastEdge = 0.02, kLeastWidth = 0.04;  // metres; what the truth may have

// Fills the square shelf by shelf: groups stand side by side, and shelves behind each other.
class TownBuilder {
 public:
  TownBuilder(WildRoofTown& wild, Draws& draws, double width) : wild_(wild), draws_(draws), width_(width) {}

  void build() {
    double v = 4;
    while (v < width_ - 8) {
      const double depth = add_shelf(v);
      v += depth + 4 + 8 * draws_.random("roofs.lane", shelf_).uniform();
      ++shelf_;
    }
  }

 private:
  double add_shelf(double v) {
    double u = 4, deepest = 6;
    int misses = 0;
    while (u < width_ - 6 && misses < 12) {
      const std::uint64_t key = element_index(shelf_, groups_);
      ++groups_;
      std::vector<WildRoof> group = draw_group(key);
      const GridRect all = box_of(group);
      const double long_side = kUnit * static_cast<double>(all.u1 - all.u0),
                   depth = kUnit * static_cast<double>(all.v1 - all.v0);
      Rng rng = draws_.random("roofs.gap", key);
      const double turn = group.size() > 1 ? 0 : 8 * (2 * rng.uniform() - 1),
                   room = 0.16 * std::max(long_side, depth) + 0.6;
      if (u + long_side + room > width_ - 3 || v + depth + room > width_ - 2) {
        ++misses;
        continue;
      }
      misses = 0;
      if (set_group(group, u + room / 2, v + room / 2, turn)) deepest = std::max(deepest, depth + room);
      u += long_side + room + draws_.number("roofs.gap", key);
    }
    return deepest;
  }

  static GridRect box_of(const std::vector<WildRoof>& group) {
    GridRect all = bounds_of(group[0].wings);
    for (const WildRoof& roof : group) {
      const GridRect own = bounds_of(roof.wings);
      all = {std::min(all.u0, own.u0), std::min(all.v0, own.v0), std::max(all.u1, own.u1), std::max(all.v1, own.v1)};
    }
    return all;
  }

  std::vector<WildRoof> draw_group(std::uint64_t key) {
    if (!draws_.happens("roofs.terraced", key)) return {draw_one(key)};
    std::vector<WildRoof> group;
    Rng rng = draws_.random("roofs.terrace", key);
    const auto houses = 2 + rng.below(7);
    Integer next = 0;
    for (std::uint64_t i = 0; i < houses; ++i) {
      RoofDesign design =
          draw_roof(rng, rng.uniform() < 0.6 ? RoofKind::gable : RoofKind::complex, BuiltForm::terraced, 0);
      const GridRect own = bounds_of(design.wings);
      const Integer back = 250 * static_cast<Integer>(rng.below(5)) - own.v0;
      WildRoof roof{name_of(design.kind), "houses", {}, {}, {}, 0};
      for (const Wing& wing : design.wings) roof.wings.push_back(moved(wing, next - own.u0, back, 0));
      next += own.u1 - own.u0;
      group.push_back(std::move(roof));
    }
    return group;
  }

  WildRoof draw_one(std::uint64_t key) {
    double total = 0;
    const auto weight = [&](const WildRoofForm& form) {
      return form.frequency * draws_.number("roofs." + std::string(form.family));
    };
    for (const WildRoofForm& form : wild_roof_forms()) total += weight(form);
    Rng rng = draws_.random("roofs.form", key);
    double left = total * rng.uniform();
    for (const WildRoofForm& form : wild_roof_forms()) {
      if (weight(form) > 0 && left < weight(form)) return form.draw(rng);
      left -= weight(form);
    }
    return wild_roof_forms()[0].draw(rng);
  }

  // Puts a group down. Buildings whose solid is not sound are left out.
  bool set_group(std::vector<WildRoof>& group, double u, double v, double turn) {
    const GridRect all = box_of(group);
    const RoofFrame frame =
        frame_at(u - kUnit * static_cast<double>(all.u0), v - kUnit * static_cast<double>(all.v0), turn);
    double foot = 1e9;
    for (const Integer a : {all.u0, all.u1})
      for (const Integer b : {all.v0, all.v1}) foot = std::min(foot, ground_at(frame, a, b));
    bool any = false;
    for (WildRoof& roof : group) any = set_building(roof, frame, foot) || any;
    return any;
  }

  double ground_at(const RoofFrame& frame, Integer u, Integer v) const {
    const Vec3 p = frame.to_town({kUnit * static_cast<double>(u), kUnit * static_cast<double>(v), 0});
    return wild_.town.ground.height(p.x, p.y);
  }

  RoofFrame frame_at(double u, double v, double turn) const {
    const SinCos h = sin_cos_deg(wild_.heading_deg);
    const double x = u - width_ / 2, y = v - width_ / 2, middle = wild_.town.area.x1 / 2;
    return {middle + x * h.cos - y * h.sin, middle + x * h.sin + y * h.cos,
            sin_cos_deg(std::remainder(wild_.heading_deg + turn, 360.0))};
  }

  bool set_building(WildRoof& roof, const RoofFrame& frame, double foot) {
    RoofBuilding building;
    building.kind = RoofKind::complex;
    building.frame = frame;
    const auto floor = static_cast<Integer>(std::floor(foot / kUnit)) - 50;
    for (const Wing& wing : roof.wings) building.wings.push_back(moved(wing, 0, 0, std::llround(foot / kUnit)));
    building.solid = build_solid(partition_roof(building.wings), floor);
    if (fault_of(building.solid, kLeastEdge, kLeastWidth)) return false;
    building.floor = kUnit * static_cast<double>(floor);
    building.eave = 1e9, building.ridge = -1e9;
    for (const RoofFace& face : building.solid.faces) {
      if (face.part != RoofPart::roof) continue;
      for (const std::uint32_t i : face.rings[0]) {
        building.eave = std::min(building.eave, building.solid.vertices[i].z);
        building.ridge = std::max(building.ridge, building.solid.vertices[i].z);
      }
    }
    dress(building);
    for (std::size_t w = 0; w < building.wings.size(); ++w) wild_.wings.push_back(surface_of(roof, building, w, foot));
    wild_.forms.push_back(roof.form);
    wild_.group.push_back(static_cast<std::uint32_t>(groups_));
    wild_.town.buildings.push_back(std::move(building));
    return true;
  }

  WingSurface surface_of(const WildRoof& roof, const RoofBuilding& building, std::size_t w, double foot) const {
    WingSurface surface{static_cast<std::uint32_t>(wild_.town.buildings.size()),
                        static_cast<std::uint32_t>(w),
                        building.wings[w].planes.size(),
                        std::nullopt,
                        false,
                        0};
    for (const CurvedRoof& curve : roof.curved) {
      if (curve.wing != w) continue;
      surface.curve = curve.surface;
      surface.curve->point = building.frame.to_town(
          curve.surface.point + Vec3{0, 0, kUnit * static_cast<double>(std::llround(foot / kUnit))});
      surface.curve->axis = building.frame.direction_to_town(curve.surface.axis);
    }
    surface.glass = std::find(roof.glass.begin(), roof.glass.end(), w) != roof.glass.end();
    surface.below = foot + kUnit * static_cast<double>(roof.below);
    return surface;
  }

  void dress(RoofBuilding& building) {
    Rng rng = draws_.random("roofs.dress", wild_.town.buildings.size());
    const bool flat = building.wings[0].planes.size() == 1;
    const double roof = rng.uniform(), wall = rng.uniform();
    building.roof = flat          ? (roof < 0.5 ? Material::zinc : Material::paving)
                    : roof < 0.55 ? Material::tile
                    : roof < 0.8  ? Material::slate
                                  : Material::zinc;
    building.wall = wall < 0.6 ? Material::render : wall < 0.8 ? Material::brick : Material::limestone;
  }

  WildRoofTown& wild_;
  Draws& draws_;
  double width_;
  std::uint64_t shelf_ = 0, groups_ = 0;
};

}  // namespace

const char* name_of(RoofExtraKind kind) {
  constexpr std::array kNames{"chimney", "solar_panel", "equipment", "parapet", "car", "balustrade"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool WildRoofTown::holds(double x, double y, double beyond) const {
  const SinCos h = sin_cos_deg(heading_deg);
  const double dx = x - town.area.x1 / 2, dy = y - town.area.y1 / 2;
  const double half = width / 2 + beyond;
  return std::abs(dx * h.cos + dy * h.sin) < half && std::abs(dy * h.cos - dx * h.sin) < half;
}

WildRoofTown build_wild_town(Draws& draws, std::uint64_t seed, double width) {
  WildRoofTown wild;
  wild.width = width;
  wild.heading_deg = draws.number("roofs.heading");
  const double side = 1.4143 * width + 20;
  wild.town.area = {0, 0, side, side};
  const SinCos way = sin_cos_deg(360 * Rng(seed, 0x726f6f667ull).uniform() - 180);
  const double slope = draws.number("roofs.slope") / 100;
  wild.town.ground = {50 + 2 * slope * side, slope * way.cos, slope * way.sin};
  TownBuilder(wild, draws, width).build();
  number_planes(wild.town);
  add_roof_extras(wild, draws);
  add_wild_trees(wild, draws);
  add_cars(wild, draws);
  return wild;
}

}  // namespace ilot::scan
