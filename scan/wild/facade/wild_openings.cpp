// SPDX-License-Identifier: Apache-2.0
// Windows, doors, shops and passages of a wild front, with their shutters.
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/optics/exact_math.h"
#include "scan/wild/facade/wild_front.h"

namespace ilot::scan {
namespace {

constexpr double kNarrowLeaf = 0.12;  // metres: leaves are not narrower

Material draw_glass(Draws& draws, std::uint64_t element, std::uint64_t house) {
  if (draws.happens("panes_without_echo", element, house)) return Material::dark_glass;
  if (draws.happens("panes_mirrored", element, house)) return Material::mirror_glass;
  if (draws.happens("panes_dusty", element, house)) return Material::dusty_glass;
  return draws.happens("panes_clear", element, house) ? Material::clear_glass : Material::glass;
}

// Borders, sills and lintels.
void draw_dressing(Draws& draws, const WildFront& front, const WildOpening& o, WindowStyle& style) {
  const std::uint64_t house = front.plot.house;
  if (draws.happens("sills", o.element, house) && o.place.row > 1) style.sill_out = draws.number("sill_out", house);
  const double beside = (bay_of(front) - (o.hole.right - o.hole.left)) / 2;
  if (o.hole.rise > 0) return;
  if (draws.happens("surrounds", o.element, house)) {
    style.surround_out = draws.number("surround_out", house);
    style.surround_width = std::min(draws.number("surround_width", house), 0.8 * beside);
  } else if (draws.happens("lintels", o.element, house)) {
    style.lintel_out = draws.number("surround_out", house);
    style.lintel_beside = std::min(0.12, 0.5 * beside);
  }
}

WindowStyle draw_style(Draws& draws, const WildFront& front, const WildOpening& o) {
  const std::uint64_t house = front.plot.house;
  WindowStyle style;
  style.classes = {static_cast<std::uint8_t>(WildClass::reveal), static_cast<std::uint8_t>(WildClass::sill),
                   static_cast<std::uint8_t>(WildClass::surround), static_cast<std::uint8_t>(WildClass::other)};
  style.wall = front.material;
  style.tone = front.tone;
  style.wall_swing = front.relief.roughness + front.relief.stone_out;
  style.recess = front.reveal;
  style.glass = draw_glass(draws, o.element, house);
  style.framed = !draws.happens("frames_missing", o.element, house);
  style.frame = std::min(draws.number("frame_width", house), 0.15 * (o.hole.right - o.hole.left));
  style.curtains = draws.number("curtains", house);
  Rng rng = draws.random("panes", house);
  style.panes_across = 1 + static_cast<int>(rng.below(3));
  style.panes_up = 1 + static_cast<int>(rng.below(4));
  if (draws.happens("blinds", o.element, house)) {
    style.blind = draws.number("blind_closed", o.element);
    style.blind_before = std::min(0.04, 0.5 * front.reveal);
  }
  draw_dressing(draws, front, o, style);
  const double sill = o.hole.bottom - front.floors[o.place.row - 1];
  if (o.place.row > 1 && sill < 0.6 && draws.happens("railings", o.element, house)) style.railing = 1 - sill;
  return style;
}

// A passage without a door: dark at its end.
void add_passage(FacadeBuilder& facade, const WildFront& front, const WildOpening& o) {
  TrueElement e;
  e.kind = "opening";
  e.row = o.place.row;
  e.column = o.place.column;
  e.ring = facade.outline(o.hole, 0);
  e.width = o.hole.right - o.hole.left;
  e.height = top_of(o.hole) - o.hole.bottom;
  const double deep = o.place.row == 1 && front.plot.gate ? front.depth : 2.5;
  e.depth = -deep;
  const std::uint32_t id = facade.add_element(e);
  facade.add_opening(id, e.ring);
  facade.reveal(o.hole, front.relief.roughness, -deep, wild_finish(WildClass::reveal, front.material, id, front.tone));
  if (front.plot.gate) return;
  facade.wall(o.hole.left - 0.01, o.hole.right + 0.01, o.hole.bottom - 0.01, top_of(o.hole) + 0.01, -deep, {},
              wild_finish(WildClass::other, Material::interior, id));
}

// Adds one leaf of a shutter: its hinge in x and out, and its way from there for a closed window (side 1 = to the
// right) turned by the angle. A closed leaf has the angle 0, one that lies on the wall 180.
struct Leaf {
  double x = 0, out = 0, side = 1, width = 0.5, angle = 0, thick = 0.03, z0 = 0, z1 = 1;
};

void add_leaf(FacadeBuilder& facade, const Leaf& leaf, const Finish& finish) {
  const SinCos turn = sin_cos_deg(leaf.angle);
  const double x = leaf.side * leaf.width * turn.cos, out = leaf.width * turn.sin;
  const double thick_x = -leaf.side * leaf.thick * turn.sin, thick_out = leaf.thick * turn.cos;
  const auto at = [&](double dx, double dout) { return facade.frame().place(leaf.x + dx, leaf.out + dout, leaf.z0); };
  const std::array<Vec3, 4> ring{at(0, 0), at(x, out), at(x + thick_x, out + thick_out), at(thick_x, thick_out)};
  facade.add(prism(ring, {0, 0, leaf.z1 - leaf.z0}, facade.surface(finish)));
}

std::uint32_t shutter_element(FacadeBuilder& facade, const WildOpening& o, double x0, double x1, double out) {
  TrueElement e;
  e.kind = "shutter";
  e.row = o.place.row;
  e.column = o.place.column;
  e.ring = facade.outline({x0, x1, o.hole.bottom, o.hole.springing, 0}, out);
  e.width = x1 - x0;
  e.height = o.hole.springing - o.hole.bottom;
  e.depth = out;
  return facade.add_element(e);
}

}  // namespace

void add_shutters(FacadeBuilder& facade, Draws& draws, const WildFront& front, const WildOpening& window) {
  const std::uint64_t house = front.plot.house;
  const Opening& o = window.hole;
  const double half = (o.right - o.left) / 2, swing = front.relief.roughness + front.relief.stone_out;
  const double room = (bay_of(front) - 2 * half) / 2 - 0.04, thick = draws.number("shutter_thickness", house);
  std::string_view state = draws.choice("shutter_state", window.element);
  const double wide = std::min(half, room);
  if (state != "closed" && wide < kNarrowLeaf) state = "closed";
  const auto tone = static_cast<std::uint8_t>(1 + draws.random("shutters", house).below(255));
  Leaf leaf{o.left + 0.004, 0, 1, half - 0.006, 0, thick, o.bottom + 0.01, o.springing - 0.005};
  if (state == "closed") {
    // They lie in the reveal where it is deep enough, else before the wall.
    const double deep = std::min(draws.number("shutter_depth", house), front.reveal - thick - 0.02);
    leaf.out = std::max(deep, -swing - 0.01) > 0 ? -deep - thick : swing + 0.005;
  } else {
    leaf.width = wide;
    leaf.out = swing + draws.number("shutter_gap", house) + thick;
    leaf.angle = state == "open" ? 180 : draws.number("shutter_angle", window.element);
  }
  for (double side : {1.0, -1.0}) {
    leaf.side = side;
    leaf.x = side > 0 ? o.left + 0.004 : o.right - 0.004;
    const double end = leaf.x + (state == "open" ? -side : side) * leaf.width;
    const std::uint32_t id = shutter_element(facade, window, std::min(leaf.x, end), std::max(leaf.x, end),
                                             state == "closed" ? leaf.out + thick : leaf.out);
    add_leaf(facade, leaf, wild_finish(WildClass::shutter, Material::wood, id, tone));
  }
}

void add_openings(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  for (const WildOpening& o : front.openings) {
    Rng rng = draws.random("room", o.element);
    if (o.use == WildUse::arcade) {
      add_passage(facade, front, o);
      continue;
    }
    WindowStyle style = draw_style(draws, front, o);
    if (o.use == WildUse::window) {
      add_window(facade, o.hole, o.place, style, rng);
      if (draws.happens("shutters", o.element, front.plot.house)) add_shutters(facade, draws, front, o);
    } else {
      style.recess = std::max(style.recess, 0.05);
      add_door(facade, o.hole, o.place, o.use == WildUse::shop ? DoorKind::shop : DoorKind::door, style, rng);
    }
  }
}

}  // namespace ilot::scan
