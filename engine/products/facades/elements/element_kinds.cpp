// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/element_kinds.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

constexpr double kDoorSill = 0.4, kDoorHeight = 1.8;  // metres: greatest height of the bottom of a door above the foot
                                                      // of the wall; least height of a door
constexpr double kDoorLine = 0.25;                    // metres between the tops of doors in one row
constexpr double kBesideOpening = 0.3;                // metres between an opening and its sill or lintel
constexpr double kUnder = 0.7;                      // share of the width of the opening that a sill or a lintel covers
constexpr double kLongerThanHigh = 2.5;             // width over height of sills and lintels, at least
constexpr double kBandShare = 0.4, kBalcony = 0.3;  // metres: balconies are lower; a thinner element is a rail
constexpr double kParapet = 1.5, kRail = 0.05;      // metres: balconies are lower; a thinner element is a rail
constexpr double kStandsOn = 0.5;                   // metres: nobody stands on a narrower element, it carries something

bool is_door(const FoundRectangle& r) {
  const Box2 box = r.box();
  return box.v0 < kDoorSill && box.height() > kDoorHeight;
}

// Whether both are beside one opening: one is above the other, with little between them.
bool are_of_one_opening(const Box2& a, const Box2& b) {
  const double common = std::min(a.u1, b.u1) - std::max(a.u0, b.u0);
  const double apart = std::max(a.v0, b.v0) - std::min(a.v1, b.v1);
  return common >= kUnder * std::min(a.width(), b.width()) && apart < kBesideOpening;
}

}  // namespace

ElementKind kind_of_opening(const FoundRectangle& r, const std::vector<FoundRectangle>& openings) {
  if (is_door(r)) return ElementKind::door;
  if (r.side(Side::bottom).status == DrawnStatus::seen || r.at(Side::top) < kDoorHeight) return ElementKind::window;
  const bool in_line = std::any_of(openings.begin(), openings.end(), [&](const FoundRectangle& o) {
    return is_door(o) && std::abs(o.at(Side::top) - r.at(Side::top)) < kDoorLine;
  });
  return in_line && r.at(Side::bottom) - r.error(Side::bottom) < kDoorSill ? ElementKind::door : ElementKind::window;
}

ElementKind kind_of_relief(const FoundRectangle& r, const std::vector<FoundRectangle>& openings, double wall_width) {
  const Box2 box = r.box();
  const bool flat = box.width() > kLongerThanHigh * box.height();
  if (flat && box.width() > kBandShare * wall_width)
    return r.depth > kBalcony ? ElementKind::balcony : ElementKind::band;
  for (const FoundRectangle& o : openings) {
    const Box2 hole = o.box();
    const double common = std::min(hole.u1, box.u1) - std::max(hole.u0, box.u0);
    if (!flat || r.depth > kBalcony || common < kUnder * hole.width() || box.width() > 2 * hole.width()) continue;
    if (std::abs(box.v1 - hole.v0) < kBesideOpening && box.v0 < hole.v0) return ElementKind::sill;
    if (std::abs(box.v0 - hole.v1) < kBesideOpening && box.v1 > hole.v1) return ElementKind::lintel;
  }
  if (r.depth <= kBalcony) return ElementKind::bulge;
  if (box.width() < kStandsOn) return ElementKind::bracket;
  return box.height() < kParapet ? ElementKind::balcony : ElementKind::protrusion;
}

void keep_nearest_sills(std::vector<ElementCandidate>& candidates) {
  const auto is_farther = [&](const ElementCandidate& t) {
    const Box2 own = t.shape.box();
    return std::any_of(candidates.begin(), candidates.end(), [&](const ElementCandidate& other) {
      const Box2 box = other.shape.box();
      const bool nearer = t.kind == ElementKind::sill ? box.v1 > own.v1 : box.v0 < own.v0;
      return other.kind == t.kind && nearer && are_of_one_opening(own, box);
    });
  };
  std::vector<std::size_t> farther;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if ((candidates[i].kind == ElementKind::sill || candidates[i].kind == ElementKind::lintel) &&
        is_farther(candidates[i]))
      farther.push_back(i);
  for (const std::size_t i : farther) candidates[i].kind = ElementKind::bulge;
}

ElementKind kind_of_large(const FoundRectangle& r, double wall_height) {
  const Box2 box = r.box();
  if (r.depth < 0) return ElementKind::recess;
  if ((box.v0 + box.v1) / 2 > wall_height) return ElementKind::eaves;
  const bool flat = box.width() > kLongerThanHigh * box.height() && box.height() < kParapet;
  return flat && r.depth > kBalcony ? ElementKind::balcony : ElementKind::protrusion;
}

bool is_rail(const ElementCandidate& t) {
  const Box2 box = t.shape.box();
  const bool unnamed = t.kind == ElementKind::bulge || t.kind == ElementKind::balcony || t.kind == ElementKind::bracket;
  return unnamed && std::min(box.width(), box.height()) < kRail;
}

}  // namespace ilot
