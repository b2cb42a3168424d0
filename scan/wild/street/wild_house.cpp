// SPDX-License-Identifier: Apache-2.0
// A house of `street-wild`: hollow, with panes set back in both walls, floors behind them, and a way through to the
// yard.
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/streets/street_houses.h"
#include "scan/wild/street/wild_street.h"

namespace ilot::scan {
namespace {

constexpr double kBelow = 3;         // metres below the threshold that walls reach
constexpr double kFloorInset = 0.3;  // of floors from the walls

// The place of a house: `along` its front and `outward` from the street; both are horizontal.
struct HouseFrame {
  Vec3 origin, along, outward;
  Vec3 at(double u, double out, double z) const { return origin + u * along + out * outward + Vec3{0, 0, z}; }
};

struct WildHouseForm {
  double width = 10, depth = 10, base = 0;
  int storeys = 3;
  double ground_floor = 3.4, storey = 2.9, reveal = 0.15;
  double window_width = 1.1, window_height = 1.6;
  bool shop = false, shutters = false, balconies = false;
  std::string_view roof;
  double pitch = 0.8;
  Material wall = Material::render;
  double passage_u = -1, passage_width = 0;  // middle; negative = none
  double eave() const { return base + ground_floor + storey * (storeys - 1); }
};

class WildHouseBuilder {
 public:
  WildHouseBuilder(StreetModel& model, const HouseFrame& frame, const WildHouseForm& form, Rng rng)
      : model_(model), frame_(frame), form_(form), rng_(rng) {}

  void build() {
    wall_ = surface(StreetClass::facade, 0, form_.wall);
    add_wall(0, true);
    add_wall(form_.depth, false);
    for (const double u : {0.0, form_.width}) add_end(u);
    add_floors();
    add_passage();
    add_trim();
    add_roof();
  }

 private:
  SurfaceId surface(StreetClass street_class, std::uint32_t plane, Material material) {
    return model_.scene.add_surface({static_cast<std::uint8_t>(street_class), plane, 0, material});
  }
  // Rooms are not judged.
  SurfaceId room() { return model_.scene.add_surface({0, 0, 0, Material::interior}); }

  void box(double u0, double u1, double out0, double out1, double z0, double z1, SurfaceId id) {
    const std::array<Vec3, 4> ring{frame_.at(u0, out0, z0), frame_.at(u1, out0, z0), frame_.at(u1, out1, z0),
                                   frame_.at(u0, out1, z0)};
    model_.scene.parts.push_back(prism(ring, {0, 0, z1 - z0}, id));
  }

  // Adds an upright panel from one place to another.
  void panel(Vec3 from, Vec3 to, double height, SurfaceId id) {
    const double length = norm(to - from);
    model_.scene.parts.push_back(Panel{
        from, (1 / length) * (to - from), {0, 0, 1}, {{0, 0}, {length, 0}, {length, height}, {0, height}}, {}, id});
  }
  void level_panel(double u0, double u1, double out0, double out1, double z, SurfaceId id) {
    model_.scene.parts.push_back(Panel{frame_.at(u0, out0, z),
                                       frame_.along,
                                       frame_.outward,
                                       {{0, 0}, {u1 - u0, 0}, {u1 - u0, out1 - out0}, {0, out1 - out0}},
                                       {},
                                       id});
  }

  bool in_passage(double u0, double u1) const {
    const double half = form_.passage_width / 2 + 0.3;
    return form_.passage_u > 0 && u0 < form_.passage_u + half && u1 > form_.passage_u - half;
  }

  std::vector<Opening> openings(bool front) {
    std::vector<Opening> all;
    const double low = form_.base - kBelow;
    const int columns = std::max(1, static_cast<int>(form_.width / (form_.window_width + 1.1)));
    const int door = static_cast<int>(rng_.below(static_cast<std::uint64_t>(columns)));
    for (int floor = 0; floor < form_.storeys; ++floor)
      for (int column = 0; column < columns; ++column) {
        const double middle = (column + 0.5) * form_.width / columns + 0.02 * (rng_.uniform() - 0.5);
        double half = form_.window_width / 2, bottom = form_.base + 0.9, top = bottom + form_.window_height;
        if (floor > 0) {
          bottom = form_.base + form_.ground_floor + form_.storey * (floor - 1) + 0.85;
          top = bottom + std::min(form_.window_height, form_.storey - 1.1);
        } else if (column == door && front) {
          half = 0.55, bottom = form_.base, top = form_.base + 2.15;
        } else if (form_.shop && front) {
          half = 0.42 * form_.width / columns, bottom = form_.base + 0.4, top = form_.base + 2.9;
        }
        if (floor == 0 && in_passage(middle - half, middle + half)) continue;
        if (rng_.uniform() < 0.06) continue;  // a blind field
        all.push_back({middle - half, middle + half, bottom - low, top - low, 0});
      }
    if (form_.passage_u > 0)
      all.push_back({form_.passage_u - form_.passage_width / 2, form_.passage_u + form_.passage_width / 2, 0.01,
                     form_.base - low + std::min(3.1, form_.ground_floor - 0.3), 0});
    return all;
  }

  void add_wall(double out, bool front) {
    const double low = form_.base - kBelow, height = form_.eave() - low;
    const Vec3 outside = front ? -1.0 * frame_.outward : frame_.outward;
    Panel wall{frame_.at(0, out, low),
               frame_.along,
               {0, 0, 1},
               {{0, 0}, {form_.width, 0}, {form_.width, height}, {0, height}},
               openings(front),
               0};
    std::vector<Vec3> ring{frame_.at(0, out, low), frame_.at(form_.width, out, low),
                           frame_.at(form_.width, out, low + height), frame_.at(0, out, low + height)};
    if (dot(cross(frame_.along, Vec3{0, 0, 1}), outside) < 0) std::reverse(ring.begin(), ring.end());
    TruePlane& truth = add_plane(model_, "facade", {outside, -dot(outside, frame_.at(0, out, low))}, ring);
    wall.surface = surface(StreetClass::facade, truth.id, form_.wall);
    for (const Opening& o : wall.openings) {
      const auto corner = [&](double u, double y) { return frame_.at(u, out, low + y); };
      std::vector<Vec3> hole{corner(o.left, o.bottom), corner(o.left, o.springing), corner(o.right, o.springing),
                             corner(o.right, o.bottom)};
      if (dot(cross(frame_.along, Vec3{0, 0, 1}), outside) < 0) std::reverse(hole.begin(), hole.end());
      truth.polygons[0].holes.push_back(std::move(hole));
      if (o.bottom > 0.1) add_window(o, out, low, front);
    }
    model_.scene.parts.push_back(std::move(wall));
  }

  // Adds the reveals, the sill and the pane of an opening, and shutters beside it.
  void add_window(const Opening& o, double out, double low, bool front) {
    const double in = front ? out + form_.reveal : out - form_.reveal, z0 = low + o.bottom, z1 = low + o.springing;
    for (const double u : {o.left, o.right}) panel(frame_.at(u, out, z0), frame_.at(u, in, z0), z1 - z0, wall_);
    for (const double z : {z0, z1}) level_panel(o.left, o.right, std::min(out, in), std::max(out, in), z, wall_);
    const double closed = rng_.uniform();
    const Material pane = closed < 0.1 ? Material::wood : closed < 0.2 ? Material::cloth : Material::glass;
    panel(frame_.at(o.left, in, z0), frame_.at(o.right, in, z0), z1 - z0, surface(StreetClass::facade, 0, pane));
    const double toward = front ? -1 : 1;
    const double frame_out = in + toward * 0.02;
    const SurfaceId wood = surface(StreetClass::facade, 0, Material::wood);
    const double middle = (o.left + o.right) / 2;
    for (const double u : {o.left + 0.03, middle, o.right - 0.03})
      box(u - 0.03, u + 0.03, std::min(in, frame_out), std::max(in, frame_out), z0, z1, wood);
    const double ledge = out + toward * 0.06;
    box(o.left - 0.06, o.right + 0.06, std::min(out, ledge), std::max(out, ledge), z0 - 0.08, z0, wall_);
    if (!form_.shutters || z0 < form_.base + 0.3) return;
    const double leaf = (o.right - o.left) / 2, shut_out = out + toward * 0.05;
    for (const double u : {o.left - leaf, o.right})
      box(u, u + leaf, std::min(out, shut_out), std::max(out, shut_out), z0, z1, wood);
  }

  void add_end(double u) {
    const double low = form_.base - kBelow, height = form_.eave() - low;
    std::vector<FlatPoint> ring{{0, 0}, {form_.depth, 0}, {form_.depth, height}, {0, height}};
    if (form_.roof == "gable") ring.insert(ring.begin() + 3, {form_.depth / 2, height + form_.pitch * form_.depth / 2});
    const Vec3 normal = u > 0 ? frame_.along : -1.0 * frame_.along;
    std::vector<Vec3> outline;
    for (const FlatPoint p : ring) outline.push_back(frame_.at(u, p.x, low + p.y));
    if (dot(cross(frame_.outward, Vec3{0, 0, 1}), normal) < 0) std::reverse(outline.begin(), outline.end());
    const std::uint32_t id = add_plane(model_, "facade", {normal, -dot(normal, frame_.at(u, 0, low))}, outline).id;
    model_.scene.parts.push_back(
        Panel{frame_.at(u, 0, low), frame_.outward, {0, 0, 1}, ring, {}, surface(StreetClass::facade, id, form_.wall)});
  }

  void add_floors() {
    const SurfaceId inside = room();
    for (int floor = 1; floor <= form_.storeys; ++floor) {
      const double z = form_.base + form_.ground_floor + form_.storey * (floor - 1);
      box(kFloorInset, form_.width - kFloorInset, kFloorInset, form_.depth - kFloorInset, z - 0.25, z, inside);
    }
    const double u0 = form_.passage_u > 0 ? form_.passage_u + form_.passage_width / 2 : 0.05;
    level_panel(u0, form_.width - 0.05, 0.05, form_.depth - 0.05, form_.base, inside);
    const double middle = form_.depth * (0.4 + 0.2 * rng_.uniform());
    panel(frame_.at(u0, middle, form_.base), frame_.at(form_.width, middle, form_.base), form_.ground_floor, inside);
    panel(frame_.at(0, middle, form_.base + form_.ground_floor),
          frame_.at(form_.width, middle, form_.base + form_.ground_floor),
          form_.eave() - form_.base - form_.ground_floor, inside);
  }

  void add_passage() {
    if (form_.passage_u < 0) return;
    for (const double side : {-0.5, 0.5}) {
      const double u = form_.passage_u + side * form_.passage_width;
      panel(frame_.at(u, 0, form_.base - kBelow), frame_.at(u, form_.depth, form_.base - kBelow),
            kBelow + form_.ground_floor, wall_);
    }
    if (rng_.uniform() > 0.4) return;
    const SurfaceId iron = surface(StreetClass::facade, 0, Material::iron);  // a gate of bars
    for (double u = form_.passage_u - form_.passage_width / 2; u < form_.passage_u + form_.passage_width / 2; u += 0.14)
      box(u, u + 0.02, 0.3, 0.32, form_.base - 0.5, form_.base + 2.6, iron);
  }

  // Adds bands, the cornice, downpipes, lamps and balconies.
  void add_trim() {
    const SurfaceId stone = surface(StreetClass::facade, 0, Material::limestone),
                    zinc = surface(StreetClass::facade, 0, Material::zinc);
    const double first = form_.base + form_.ground_floor;
    if (rng_.uniform() < 0.6) box(0, form_.width, -0.06, 0.02, first - 0.2, first, stone);
    box(0, form_.width, -0.1 - 0.3 * rng_.uniform(), 0.02, form_.eave() - 0.3, form_.eave(), stone);
    if (rng_.uniform() < 0.7) {
      const Vec3 foot = frame_.at(0.15, -0.1, form_.base);
      model_.scene.parts.push_back(cylinder(foot, {0, 0, 1}, form_.eave() - form_.base, 0.05, zinc));
    }
    if (rng_.uniform() < 0.3) {
      const double u = (0.2 + 0.6 * rng_.uniform()) * form_.width;
      box(u, u + 0.1, -0.9, 0, first - 0.6, first - 0.05, zinc);  // a sign across the pavement
    }
    if (!form_.balconies) return;
    const SurfaceId iron = surface(StreetClass::facade, 0, Material::iron);
    for (int floor = 1; floor < form_.storeys; ++floor) {
      const double z = form_.base + form_.ground_floor + form_.storey * (floor - 1);
      const double u0 = 0.15 * form_.width, u1 = 0.85 * form_.width, out = -0.6 - 0.6 * rng_.uniform();
      box(u0, u1, out, 0, z - 0.15, z, stone);
      for (double u = u0; u < u1; u += 0.12) box(u, u + 0.02, out, out + 0.02, z, z + 1, iron);
      box(u0, u1, out - 0.01, out + 0.03, z + 0.97, z + 1.02, iron);
    }
  }

  void add_roof_prism(std::vector<std::pair<double, double>> profile) {
    std::vector<Vec3> ring;
    for (const auto& [out, z] : profile) ring.push_back(frame_.at(-0.02, out, z));
    const Vec3 along = (form_.width + 0.04) * frame_.along;
    Solid roof = prism(ring, along, surface(StreetClass::roof, 0, Material::tile));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t next = (i + 1) % ring.size();
      if (roof.planes[i].n.z < 0.05) continue;
      std::vector<Vec3> outline{ring[i], ring[next], ring[next] + along, ring[i] + along};
      if (dot(cross(outline[1] - outline[0], outline[2] - outline[1]), roof.planes[i].n) < 0)
        std::reverse(outline.begin(), outline.end());
      const std::uint32_t id = add_plane(model_, "roof", roof.planes[i], outline).id;
      roof.surfaces[i] = surface(StreetClass::roof, id, form_.roof == "flat" ? Material::zinc : Material::tile);
    }
    model_.scene.parts.push_back(roof);
  }

  // Two slabs that lean against each other and hang over the walls.
  void add_gable(double z) {
    const double d = form_.depth, low = z - 0.4 * form_.pitch, top = z + form_.pitch * d / 2, thick = 0.2;
    add_roof_prism({{-0.4, low}, {d / 2, top}, {d / 2, top + thick}, {-0.4, low + thick}});
    add_roof_prism({{d + 0.4, low}, {d + 0.4, low + thick}, {d / 2, top + thick}, {d / 2, top}});
  }

  void add_roof() {
    const double z = form_.eave(), d = form_.depth;
    if (form_.roof == "flat")
      add_roof_prism({{0, z - 0.1}, {d, z - 0.1}, {d, z + 0.05}, {0, z + 0.05}});
    else if (form_.roof == "mansard")
      add_roof_prism({{0, z - 0.1}, {d, z - 0.1}, {d, z}, {d - 1.2, z + 2.5}, {1.2, z + 2.5}, {0, z}});
    else
      add_gable(z);
    const SurfaceId brick = surface(StreetClass::roof, 0, Material::brick);
    const double top = form_.roof == "gable" ? z + form_.pitch * d / 2 : z + 2;
    const auto chimneys = rng_.below(3);
    for (std::uint64_t i = 0; i < chimneys; ++i) {
      const double u = (0.1 + 0.8 * rng_.uniform()) * form_.width, out = (0.4 + 0.2 * rng_.uniform()) * d;
      box(u, u + 0.5, out, out + 0.7, z, top + 0.4 + 0.8 * rng_.uniform(), brick);
    }
  }

  StreetModel& model_;
  HouseFrame frame_;
  WildHouseForm form_;
  Rng rng_;
  SurfaceId wall_ = 0;
};

WildHouseForm draw_form(Draws& draws, std::uint64_t id, double width, double depth) {
  WildHouseForm form;
  form.width = width;
  form.depth = depth;
  form.storeys = draws.whole("street.storeys", id);
  form.ground_floor = draws.number("street.ground_floor", id);
  form.storey = draws.number("street.storey_height", id);
  form.reveal = draws.number("street.reveal", id);
  form.window_width = draws.number("street.window_width", id);
  form.window_height = draws.number("street.window_height", id);
  form.roof = draws.choice("street.roof", id);
  form.pitch = draws.number("street.roof_pitch", id);
  form.shop = draws.happens("street.shops", id);
  form.shutters = draws.happens("street.shutters", id);
  form.balconies = draws.happens("street.balconies", id);
  constexpr std::array kWalls{Material::limestone, Material::render, Material::render, Material::brick};
  form.wall = kWalls[draws.random("street.wall", id).below(kWalls.size())];
  return form;
}

}  // namespace

void add_wild_house(WildStreetModel& model, const WildStreet& street, const StreetPlot& plot, Draws& draws) {
  WildHouseForm form = draw_form(draws, plot.id, plot.s1 - plot.s0, plot.depth);
  const double front = street.half_street() + plot.setback;
  const auto height = [&](double s) { return street.ground_height(s, plot.side * (front - 0.05)); };
  form.base = std::max({height(plot.s0), height((plot.s0 + plot.s1) / 2), height(plot.s1)}) +
              draws.number("street.plinth", plot.id);
  if (plot.passage) {
    form.passage_u = plot.passage_s - plot.s0;
    form.passage_width = plot.passage_width;
  }
  const double side = plot.side;
  const HouseFrame frame{{plot.s0, side * front, 0}, {1, 0, 0}, {0, side, 0}};
  WildHouseBuilder(model.street, frame, form, draws.random("street.house", plot.id)).build();
  const auto end = [&](double s) { return street.to_scene({s, side * front, height(s)}); };
  model.blocks.push_back({plot.id, plot.side > 0 ? "left" : "right", end(plot.s0), end(plot.s1)});
}

// Closes both ends of a court with a house across the street, which has a way through.
void add_court_ends(WildStreetModel& model, const WildStreet& street, Draws& draws) {
  for (const int end : {-1, 1}) {
    const std::uint64_t id = 100000 + static_cast<std::uint64_t>(end + 1);
    const double half = street.half_street() + 1, s = end < 0 ? -3 : street.length + 3;
    WildHouseForm form = draw_form(draws, id, 2 * half, 9);
    form.base = std::max(street.ground_height(s, 0), street.ground_height(s, street.half_road + 0.1)) + 0.05;
    form.passage_u = half;
    form.passage_width = std::min(3.5, street.half_road);
    const HouseFrame frame{{s, -half, 0}, {0, 1, 0}, {static_cast<double>(end), 0, 0}};
    WildHouseBuilder(model.street, frame, form, draws.random("street.house", id)).build();
  }
}

}  // namespace ilot::scan
