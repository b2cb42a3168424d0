// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/outside_wall.h"

#include <algorithm>

namespace ilot {
namespace {

// Derived: more than half, so that what lies on the border of two walls is drawn on one of them.
constexpr double kMostInside = 0.5;  // share of the width of an element

bool is_opening_or_leaf(ElementKind kind) {
  return kind == ElementKind::window || kind == ElementKind::door || kind == ElementKind::shutter;
}

bool may_be_below(ElementKind kind) {
  return kind == ElementKind::recess || kind == ElementKind::protrusion;
}

// Removes corners that lie on the line between their neighbours, and repeated ones.
void drop_needless_corners(std::vector<Place2>& ring) {
  for (bool more = true; more && ring.size() > 2;) {
    more = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() > 2; ++i) {
      const Place2 &a = ring[(i + ring.size() - 1) % ring.size()], &b = ring[i], &c = ring[(i + 1) % ring.size()];
      if ((a.u != b.u || b.u != c.u) && (a.v != b.v || b.v != c.v)) continue;
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      more = true;
      break;
    }
  }
}

}  // namespace

void drop_elements_outside(const Box2& wall, std::vector<ElementCandidate>& candidates) {
  std::erase_if(candidates, [&](const ElementCandidate& t) {
    if (is_opening_or_leaf(t.kind)) return false;
    const Box2 box = t.shape.box();
    const double inside = std::min(box.u1, wall.u1) - std::max(box.u0, wall.u0);
    return inside < kMostInside * box.width() || (box.v1 <= wall.v0 && !may_be_below(t.kind));
  });
}

void cut_at_wall(const Box2& wall, std::vector<UnseenArea>& areas) {
  for (UnseenArea& area : areas) {
    for (Place2& p : area.ring) p = {std::clamp(p.u, wall.u0, wall.u1), std::clamp(p.v, wall.v0, wall.v1)};
    drop_needless_corners(area.ring);
  }
  std::erase_if(areas, [](const UnseenArea& area) {
    if (area.ring.size() < 3) return true;
    const Box2 box = box_of(area.ring);
    return std::min(box.width(), box.height()) < area.error;
  });
}

}  // namespace ilot
