// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/window.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/arch.h"

namespace ilot::scan {
namespace {

constexpr double kBar = 0.035;  // metres
constexpr double kGlassBehind = 0.02, kCurtainBehind = 0.15;
constexpr double kRoomDepth = 3;

double width_of(const Opening& o) {
  return o.right - o.left;
}

double middle_of(const Opening& o) {
  return (o.left + o.right) / 2;
}

TrueElement describe(const FacadeBuilder& facade, const char* kind, const Opening& o, Place place, double depth) {
  TrueElement element;
  element.kind = kind;
  element.row = place.row;
  element.column = place.column;
  element.ring = facade.outline(o, 0);
  element.width = width_of(o);
  element.height = top_of(o) - o.bottom;
  element.depth = depth;
  if (o.head != ArchHead::circular) {
    for (const ArchArc& arc : arcs_of(o))
      element.arcs.push_back(
          {facade.frame().place(arc.centre.x, 0, arc.centre.y), arc.radius, arc.from_deg, arc.to_deg});
  } else if (o.rise > 0) {
    const double radius = arch_radius(o), half = arch_half_angle_deg(o);
    element.arcs.push_back({facade.frame().place(middle_of(o), 0, top_of(o) - radius), radius, 90 - half, 90 + half});
  }
  return element;
}

// Returns the openings of the frame for its panes, within a rectangle that contains the whole opening.
std::vector<Opening> panes_of(const Opening& o, const WindowStyle& style) {
  std::vector<Opening> panes;
  const double left = o.left + style.frame, right = o.right - style.frame, bottom = o.bottom + style.frame;
  const double top = top_of(o) - (o.rise > 0 ? 0 : style.frame);
  const double across = (right - left + kBar) / style.panes_across, up = (top - bottom + kBar) / style.panes_up;
  for (int row = 0; row < style.panes_up; ++row)
    for (int column = 0; column < style.panes_across; ++column)
      panes.push_back({left + column * across, left + (column + 1) * across - kBar, bottom + row * up,
                       bottom + (row + 1) * up - kBar, 0});
  return panes;
}

void add_room(FacadeBuilder& facade, const Opening& o, double front, double beside, const Finish& finish) {
  const double x0 = o.left - beside, x1 = o.right + beside, z0 = o.bottom - 0.7, z1 = top_of(o) + 0.4;
  const double back = front - kRoomDepth;
  facade.plate({{x0, back, z0}, {x1, back, z0}, {x1, back, z1}, {x0, back, z1}}, finish, Faces::unnamed);
  facade.plate({{x0, back, z0}, {x0, back, z1}, {x0, front, z1}, {x0, front, z0}}, finish, Faces::unnamed);
  facade.plate({{x1, front, z0}, {x1, front, z1}, {x1, back, z1}, {x1, back, z0}}, finish, Faces::unnamed);
  facade.plate({{x0, back, z0}, {x0, front, z0}, {x1, front, z0}, {x1, back, z0}}, finish, Faces::unnamed);
  facade.plate({{x0, back, z1}, {x1, back, z1}, {x1, front, z1}, {x0, front, z1}}, finish, Faces::unnamed);
}

void add_curtains(FacadeBuilder& facade, const Opening& o, double out, double share, const Finish& finish, Rng& rng) {
  const double left = share * width_of(o) * rng.uniform() / 2, right = share * width_of(o) * rng.uniform() / 2;
  const double z0 = o.bottom - 0.05, z1 = top_of(o) + 0.05;
  for (const auto& [x0, x1] : {std::pair{o.left - 0.05, o.left + left}, {o.right - right, o.right + 0.05}})
    if (x1 - x0 > 0.1)
      facade.plate({{x0, out, z0}, {x1, out, z0}, {x1, out, z1}, {x0, out, z1}}, finish, Faces::unnamed);
}

// Adds frame, panes, curtains and room at the back of the opening.
void glaze(FacadeBuilder& facade, const Opening& o, const WindowStyle& style, std::uint32_t element, Rng& rng) {
  const auto finish = [&](Material m) { return Finish{style.classes.other, element, m}; };
  const double out = -style.recess, e = kOverlap;
  if (style.framed)
    facade.wall(o.left - e, o.right + e, o.bottom - e, top_of(o) + e, out, panes_of(o, style), finish(Material::wood));
  facade.wall(o.left - e, o.right + e, o.bottom - e, top_of(o) + e, out - kGlassBehind, {}, finish(style.glass));
  if (style.blind > 0)
    facade.wall(o.left - e, o.right + e, top_of(o) - style.blind * (top_of(o) - o.bottom), top_of(o) + e,
                out + style.blind_before, {}, {style.classes.other, element, Material::wood, style.tone});
  add_curtains(facade, o, out - kCurtainBehind, style.curtains, finish(Material::cloth), rng);
  add_room(facade, o, out - e, style.room_beside, finish(Material::interior));
}

void add_sill(FacadeBuilder& facade, const Opening& o, Place place, const WindowStyle& style) {
  const double x0 = o.left - style.sill_beside, x1 = o.right + style.sill_beside;
  const Opening front{x0, x1, o.bottom - style.sill_height, o.bottom, 0};
  TrueElement sill = describe(facade, "sill", front, place, style.sill_out);
  sill.ring = facade.outline(front, style.sill_out);
  const std::uint32_t id = facade.add_element(sill);
  const Finish finish{style.classes.sill, id, style.wall, style.tone};
  facade.block({x0, x1, -kOverlap, style.sill_out, front.bottom, front.springing}, finish);
  facade.block({o.left, o.right, -style.recess - kOverlap, 0, front.bottom, front.springing}, finish);
  for (double x : {x0, x1}) {
    facade.control_point("sill_top", id, x, style.sill_out, front.springing);
    facade.control_point("sill_bottom", id, x, style.sill_out, front.bottom);
  }
}

void add_lintel(FacadeBuilder& facade, const Opening& o, Place place, const WindowStyle& style) {
  const Opening front{o.left - style.lintel_beside, o.right + style.lintel_beside, top_of(o),
                      top_of(o) + style.lintel_height, 0};
  TrueElement lintel = describe(facade, "lintel", front, place, style.lintel_out);
  lintel.ring = facade.outline(front, style.lintel_out);
  const Finish finish{style.classes.lintel, facade.add_element(lintel), style.wall, style.tone};
  facade.block({front.left, front.right, -kOverlap, style.lintel_out, front.bottom, front.springing}, finish);
}

// Adds two upright borders and one above them, all of one thickness.
void add_surround(FacadeBuilder& facade, const Opening& o, const WindowStyle& style, std::uint32_t element) {
  const Finish finish{style.classes.lintel, element, style.wall, style.tone};
  const double w = style.surround_width, out = style.surround_out, top = top_of(o);
  facade.block({o.left - w, o.left, -kOverlap, out, o.bottom, top + w}, finish);
  facade.block({o.right, o.right + w, -kOverlap, out, o.bottom, top + w}, finish);
  facade.block({o.left, o.right, -kOverlap, out, top, top + w}, finish);
}

}  // namespace

void add_railing(FacadeBuilder& facade, double x0, double x1, double out, double z, double height,
                 const Finish& finish) {
  constexpr double kSpacing = 0.12, kBarRadius = 0.008, kRail = 0.02;
  const int bars = std::max(1, static_cast<int>(std::floor((x1 - x0) / kSpacing)));
  for (int i = 0; i <= bars; ++i) facade.post(x0 + (x1 - x0) * i / bars, out, z + 0.08, z + height, kBarRadius, finish);
  for (double at : {z + 0.08, z + height})
    facade.block({x0, x1, out - kRail, out + kRail, at - kRail, at + kRail}, finish, Faces::unnamed);
}

std::uint32_t add_window(FacadeBuilder& facade, const Opening& opening, Place place, const WindowStyle& style,
                         Rng& rng) {
  const std::uint32_t id = facade.add_element(describe(facade, "window", opening, place, -style.recess));
  facade.add_opening(id, facade.outline(opening, 0));
  for (double x : {opening.left, opening.right}) {
    facade.control_point("window_top", id, x, 0, opening.springing);
    facade.control_point("window_bottom", id, x, 0, opening.bottom);
  }
  const Finish reveal{style.classes.reveal, id, style.wall, style.tone};
  const bool has_sill = style.sill_out > 0;
  facade.reveal(opening, style.wall_swing, -style.recess, reveal,
                has_sill ? FacadeBuilder::Ledge::without : FacadeBuilder::Ledge::with);
  if (style.surround_out > 0) add_surround(facade, opening, style, id);
  if (has_sill) add_sill(facade, opening, place, style);
  if (style.lintel_out > 0) add_lintel(facade, opening, place, style);
  if (style.railing > 0)
    add_railing(facade, opening.left + 0.01, opening.right - 0.01, -0.05, opening.bottom, style.railing,
                {style.classes.other, id, Material::iron});
  glaze(facade, opening, style, id, rng);
  return id;
}

std::uint32_t add_door(FacadeBuilder& facade, const Opening& opening, Place place, DoorKind kind,
                       const WindowStyle& style, Rng& rng) {
  const char* name = kind == DoorKind::door ? "door" : "shop";
  const std::uint32_t id = facade.add_element(describe(facade, name, opening, place, -style.recess));
  facade.add_opening(id, facade.outline(opening, 0));
  facade.reveal(opening, style.wall_swing, -style.recess, {style.classes.reveal, id, style.wall, style.tone});
  if (kind == DoorKind::shop) {
    WindowStyle front = style;
    front.panes_across = 3;
    front.panes_up = 1;
    glaze(facade, opening, front, id, rng);
    facade.block({opening.left, opening.right, -style.recess - kOverlap, -style.recess + 0.06, opening.bottom,
                  opening.bottom + 0.5},
                 {style.classes.other, id, Material::wood});
    return id;
  }
  const Finish wood{style.classes.other, id, Material::wood};
  const double e = kOverlap, x = middle_of(opening), top = opening.springing;
  facade.wall(opening.left - e, opening.right + e, opening.bottom - e, top_of(opening) + e, -style.recess, {}, wood);
  const double leaf = width_of(opening) / 2, height = (top - opening.bottom) / 3;
  for (double left : {opening.left, x})
    for (int panel = 0; panel < 3; ++panel)
      facade.block({left + 0.1, left + leaf - 0.1, -style.recess - e, -style.recess + 0.025,
                    opening.bottom + 0.1 + panel * height, opening.bottom - 0.05 + (panel + 1) * height},
                   wood);
  return id;
}

}  // namespace ilot::scan
