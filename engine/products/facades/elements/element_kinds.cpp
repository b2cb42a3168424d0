// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/element_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ilot {
namespace {

// Choice: a step in front of one of two doors; doors in one row whose lintels differ by more are not recognised from
// each other.
constexpr double kDoorLine = 0.25;  // metres between the tops of doors in one row
// Choice: a course of stone between an opening and its sill; a sill lower than that becomes a bulge.
constexpr double kBesideOpening = 0.3;  // metres between an opening and its sill or lintel
// Choice: a keystone as high as a third of its width is no lintel and becomes a bulge.
constexpr double kLongerThanHigh = 2.5;  // width over height of sills and lintels, at least
// Choice: a band broken at every window may be shorter and becomes bulges.
constexpr double kBandShare = 0.4;  // share of the width of the wall that a band covers, at least
// Choice: handrails are 4 to 5 cm thick; a parapet of thin metal looks like a rail too.
constexpr double kRail = 0.05;  // metres; a thinner element is a rail

// Derived: more than half, so that two openings of one size of which one gives way are those that lie nearest.
constexpr double kWithin = 0.5;  // share of an opening that lies in another one

bool is_door(const FoundRectangle& r, const ElementKindParams& params) {
  const Box2 box = r.box();
  return box.v0 < params.door_sill && box.height() > params.door_height;
}

// Whether both are beside one opening: one is above the other, with little between them.
bool are_of_one_opening(const Box2& a, const Box2& b) {
  const double common = std::min(a.u1, b.u1) - std::max(a.u0, b.u0);
  const double apart = std::max(a.v0, b.v0) - std::min(a.v1, b.v1);
  return common >= kUnder * std::min(a.width(), b.width()) && apart < kBesideOpening;
}

}  // namespace

ElementKind kind_of_opening(const FoundRectangle& r, const std::vector<FoundRectangle>& openings,
                            const ElementKindParams& params) {
  if (is_door(r, params)) return ElementKind::door;
  if (r.side(Side::bottom).status == DrawnStatus::seen || r.at(Side::top) < params.door_height)
    return ElementKind::window;
  const bool in_line = std::any_of(openings.begin(), openings.end(), [&](const FoundRectangle& o) {
    return is_door(o, params) && std::abs(o.at(Side::top) - r.at(Side::top)) < kDoorLine;
  });
  return in_line && r.at(Side::bottom) - r.error(Side::bottom) < params.door_sill ? ElementKind::door
                                                                                  : ElementKind::window;
}

ElementKind kind_of_relief(const FoundRectangle& r, const std::vector<FoundRectangle>& openings, double wall_width,
                           const ElementKindParams& params) {
  const Box2 box = r.box();
  const bool flat = box.width() > kLongerThanHigh * box.height();
  if (flat && box.width() > kBandShare * wall_width)
    return r.depth > params.balcony_depth ? ElementKind::balcony : ElementKind::band;
  for (const FoundRectangle& o : openings) {
    const Box2 hole = o.box();
    const double common = std::min(hole.u1, box.u1) - std::max(hole.u0, box.u0);
    if (!flat || r.depth > params.balcony_depth || common < kUnder * hole.width() || box.width() > 2 * hole.width())
      continue;
    if (std::abs(box.v1 - hole.v0) < kBesideOpening && box.v0 < hole.v0) return ElementKind::sill;
    if (std::abs(box.v0 - hole.v1) < kBesideOpening && box.v1 > hole.v1) return ElementKind::lintel;
  }
  if (r.depth <= params.balcony_depth) return ElementKind::bulge;
  if (box.width() < params.balcony_width) return ElementKind::bracket;
  return box.height() < params.balcony_height ? ElementKind::balcony : ElementKind::protrusion;
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

ElementKind kind_of_large(const FoundRectangle& r, double wall_height, const ElementKindParams& params) {
  const Box2 box = r.box();
  if (r.depth < 0) return ElementKind::recess;
  if ((box.v0 + box.v1) / 2 > wall_height) return ElementKind::eaves;
  const bool flat = box.width() > kLongerThanHigh * box.height() && box.height() < params.balcony_height;
  return flat && r.depth > params.balcony_depth ? ElementKind::balcony : ElementKind::protrusion;
}

bool is_rail(const ElementCandidate& t) {
  const Box2 box = t.shape.box();
  const bool unnamed = t.kind == ElementKind::bulge || t.kind == ElementKind::balcony || t.kind == ElementKind::bracket;
  return unnamed && std::min(box.width(), box.height()) < kRail;
}

void drop_openings_within(std::vector<ElementCandidate>& candidates) {
  std::vector<std::size_t> openings;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (is_opening(candidates[i].kind)) openings.push_back(i);
  const auto area = [&](std::size_t i) { return area_of(candidates[i].shape.box()); };
  std::sort(openings.begin(), openings.end(), [&](std::size_t a, std::size_t b) {
    if (candidates[a].possible != candidates[b].possible) return candidates[b].possible;
    return area(a) != area(b) ? area(a) > area(b) : a < b;
  });
  std::vector<bool> dropped(candidates.size(), false);
  std::vector<std::size_t> kept;
  for (const std::size_t i : openings) {
    const Box2 own = candidates[i].shape.box();
    dropped[i] = std::any_of(kept.begin(), kept.end(), [&](std::size_t k) {
      return common_area(own, candidates[k].shape.box()) > kWithin * area_of(own);
    });
    if (!dropped[i]) kept.push_back(i);
  }
  std::vector<ElementCandidate> left;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!dropped[i]) left.push_back(std::move(candidates[i]));
  candidates = std::move(left);
}

}  // namespace ilot
