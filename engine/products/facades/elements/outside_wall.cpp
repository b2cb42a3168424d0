// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/outside_wall.h"

#include <algorithm>
#include <cmath>

#include "engine/products/facades/elements/element_box.h"
#include "engine/products/facades/elements/facade_elements.h"

namespace ilot {
namespace {

// Derived: more than half, so that what lies on the border of two walls is drawn on one of them.
constexpr double kMostInside = 0.5;  // share of the width of an element

// Choice: the error of the end of a wall that meets a tower.
constexpr double kBesideWall = 0.1;  // metres between the end of the wall and a part of the house beside it

// Choice: the depth of what has no front is that of its farthest points, which are a step or two apart.
constexpr double kAtDeepest = 0.1;  // metres short of the end of the search in which a body goes on beyond it

bool is_opening_or_leaf(ElementKind kind) {
  return kind == ElementKind::window || kind == ElementKind::door || kind == ElementKind::shutter;
}

// Derived: coordinates are written to a tenth of a millimetre.
constexpr double kRounding = 1e-4;  // metres

// Whether an element may be a part of the house below its wall or beside it: a storey, a tower at its corner.
bool may_be_wall(ElementKind kind) {
  return kind == ElementKind::recess || kind == ElementKind::protrusion;
}

// Moves the corners of a ring that are outside of a box to its border.
void cut_ring(const Facade& f, const Box2& wall, double metres, FacadeElement& e) {
  for (Vec3& p : e.ring) {
    const Place2 at = local_place(f, p, metres);
    const double u = std::clamp(at.u, wall.u0, wall.u1) - at.u, v = std::clamp(at.v, wall.v0, wall.v1) - at.v;
    if (u != 0 || v != 0) p = p + (u / metres) * f.right + (v / metres) * f.up;
  }
}

// Removes the corners between two edges that lie on one line, with the second of these edges.
void drop_needless_corners(const Facade& f, double metres, FacadeElement& e) {
  for (std::size_t i = 0; i < e.ring.size() && e.ring.size() > 2;) {
    const std::size_t n = e.ring.size();
    const Place2 a = local_place(f, e.ring[(i + n - 1) % n], metres), b = local_place(f, e.ring[i], metres),
                 c = local_place(f, e.ring[(i + 1) % n], metres);
    const auto same = [](double x, double y) { return std::abs(x - y) < kRounding; };
    if ((same(a.u, b.u) && same(b.u, c.u)) || (same(a.v, b.v) && same(b.v, c.v))) {
      e.ring.erase(e.ring.begin() + static_cast<std::ptrdiff_t>(i));
      if (i < e.edges.size()) e.edges.erase(e.edges.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 1 ? i - 2 : 0;
    } else {
      ++i;
    }
  }
}

}  // namespace

void drop_elements_outside(const Box2& wall, double deepest, std::vector<ElementCandidate>& candidates) {
  std::erase_if(candidates, [&](const ElementCandidate& t) {
    if (is_opening_or_leaf(t.kind)) return false;
    const Box2 box = t.shape.box();
    const double inside = std::min(box.u1, wall.u1) - std::max(box.u0, wall.u0);
    if (t.kind == ElementKind::protrusion && inside < kBesideWall && t.shape.depth > deepest - kAtDeepest) return true;
    const double least = may_be_wall(t.kind) ? -kBesideWall : kMostInside * box.width();
    return inside < least || (box.v1 <= wall.v0 && !may_be_wall(t.kind));
  });
}

void cut_unseen_at_outline(Facade& facade, double metres_per_unit) {
  const auto outline = std::find_if(facade.elements.begin(), facade.elements.end(),
                                    [](const FacadeElement& e) { return e.kind == "outline" && !e.ring.empty(); });
  if (outline == facade.elements.end()) return;
  const Box2 wall = local_box(facade, *outline, metres_per_unit);
  std::erase_if(facade.elements, [&](FacadeElement& e) {
    if (!is_unseen_place(e)) return false;
    const Box2 before = local_box(facade, e, metres_per_unit);
    if (wall.contains({before.u0, before.v0}) && wall.contains({before.u1, before.v1})) return false;
    cut_ring(facade, wall, metres_per_unit, e);
    drop_needless_corners(facade, metres_per_unit, e);
    const Box2 box = local_box(facade, e, metres_per_unit);
    e.width_m = box.width(), e.height_m = box.height();
    return e.ring.size() < 3 || std::min(box.width(), box.height()) < kRounding;
  });
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) facade.elements[i].id = i + 1;
}

}  // namespace ilot
