// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/edited_element.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot {
namespace {

void add_reason(const std::string& text, FacadeElement& element) {
  if (element.reason.find(text) == std::string::npos)
    element.reason = text + (element.reason.empty() ? "" : "; ") + element.reason;
  element.status = DrawnStatus::by_hand;
}

void set_by_hand(FacadeEdge& edge) {
  edge = {};
  edge.status = DrawnStatus::by_hand;
}

Place2 place_in(const Facade& facade, Vec3 place, double metres_per_unit) {
  const Vec3 d = metres_per_unit * (place - facade.origin);
  return {dot(d, facade.right), dot(d, facade.up)};
}

// Which sides of a box moved, in the order of kSides.
struct MovedSides {
  bool left = false, right = false, bottom = false, top = false;
};

// The side of an edge is where its middle lies, as seen from the middle of the box.
bool is_moved(const MovedSides& moved, const Box2& box, Place2 a, Place2 b) {
  const double u = (a.u + b.u) / 2 - (box.u0 + box.u1) / 2, v = (a.v + b.v) / 2 - (box.v0 + box.v1) / 2;
  if (std::abs(b.u - a.u) < std::abs(b.v - a.v)) return u < 0 ? moved.left : moved.right;
  return v < 0 ? moved.bottom : moved.top;
}

}  // namespace

Box2 box_in(const Facade& facade, const FacadeElement& element, double metres_per_unit) {
  std::vector<Place2> ring;
  for (const Vec3& p : element.ring) ring.push_back(place_in(facade, p, metres_per_unit));
  return box_of(ring);
}

double shared_area(const Box2& a, const Box2& b) {
  const double common = common_area(a, b);
  const double all = a.width() * a.height() + b.width() * b.height() - common;
  return all > 0 ? common / all : 0;
}

FacadeElement drawn_opening(const Facade& facade, const std::string& kind, const Box2& box, double metres_per_unit) {
  FacadeElement e;
  e.kind = kind;
  e.opening = true;
  const auto corner = [&](double u, double v) {
    e.ring.push_back(facade.origin + (u / metres_per_unit) * facade.right + (v / metres_per_unit) * facade.up);
    set_by_hand(e.edges.emplace_back());
  };
  corner(box.u0, box.v0), corner(box.u1, box.v0), corner(box.u1, box.v1), corner(box.u0, box.v1);
  e.width_m = box.width();
  e.height_m = box.height();
  add_reason("added by hand", e);
  return e;
}

void move_element(const Facade& facade, const Box2& to, double same_m, double metres_per_unit, FacadeElement& e) {
  const Box2 from = box_in(facade, e, metres_per_unit);
  const auto differs = [&](double a, double b) { return std::abs(a - b) > same_m; };
  const MovedSides moved{differs(from.u0, to.u0), differs(from.u1, to.u1), differs(from.v0, to.v0),
                         differs(from.v1, to.v1)};
  for (std::size_t i = 0; i < e.edges.size() && e.edges.size() == e.ring.size(); ++i)
    if (is_moved(moved, from, place_in(facade, e.ring[i], metres_per_unit),
                 place_in(facade, e.ring[(i + 1) % e.ring.size()], metres_per_unit)))
      set_by_hand(e.edges[i]);
  const bool same_size = !differs(from.width(), to.width()) && !differs(from.height(), to.height());
  const auto shifted = [&](Vec3 p) {
    const Place2 at = place_in(facade, p, metres_per_unit);
    double du = to.u0 - from.u0, dv = to.v0 - from.v0;
    if (!same_size) {
      du = to.u0 + (at.u - from.u0) * to.width() / from.width() - at.u;
      dv = to.v0 + (at.v - from.v0) * to.height() / from.height() - at.v;
    }
    return p + (du / metres_per_unit) * facade.right + (dv / metres_per_unit) * facade.up;
  };
  for (Vec3& p : e.ring) p = shifted(p);
  if (same_size) {
    for (FacadeArc& arc : e.arcs) arc.centre = shifted(arc.centre);
    for (Vec3& p : e.body.vertices) p = shifted(p);
  } else {
    e.arcs.clear();
    e.body = {};
    e.width_m = to.width();
    e.height_m = to.height();
  }
  if (moved.left || moved.right) e.width_error_m = 0;
  if (moved.bottom || moved.top) e.height_error_m = 0;
  add_reason("moved by hand", e);
}

void rename_opening(const std::string& kind, FacadeElement& e) {
  if (!e.opening)
    for (FacadeEdge& edge : e.edges) set_by_hand(edge);
  if (!e.opening) e.width_error_m = e.height_error_m = 0, e.reason.clear();
  e.kind = kind;
  e.opening = true;
  e.region = FacadeRegion::element;
  add_reason("kind set by hand", e);
}

}  // namespace ilot
