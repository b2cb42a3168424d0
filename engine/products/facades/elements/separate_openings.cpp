// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/separate_openings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "engine/products/facades/elements/element_kinds.h"
#include "engine/products/facades/openings/arched_top.h"

namespace ilot {
namespace {

// Derived: more than half; of two such openings one is dropped (drop_openings_within).
constexpr double kMostOfSmaller = 0.5;  // share of the smaller opening that two have in common
// Choice: the error of a sharp edge; openings that touch within it are not said to overlap.
constexpr double kTouch = 0.01;  // metres

// One of two openings that overlap, and its side that faces the other one.
struct Facing {
  ElementCandidate& opening;
  Side side;

  LocatedEdge& edge() const { return opening.shape.side(side); }
};

// Two openings that overlap; the left or lower one is the first.
struct Overlap {
  Facing first, second;
};

double stated_error(const LocatedEdge& edge) {
  return std::max(edge.error, edge.form);
}

// Whether a side is known worse than another one: nobody saw it, or its error is larger.
bool is_worse(const Facing& a, const Facing& b) {
  const bool seen_a = a.edge().status == DrawnStatus::seen, seen_b = b.edge().status == DrawnStatus::seen;
  return seen_a != seen_b ? !seen_a : stated_error(a.edge()) > stated_error(b.edge());
}

// Moves a side. An arch, a point or a leaning side was found with the side where it was: the opening becomes a
// rectangle, whose error of form is the height of its head.
void move_side(const Facing& facing, double at) {
  FoundRectangle& shape = facing.opening.shape;
  LocatedEdge& head = shape.side(Side::top);
  if (shape.arc || shape.pointed) head.form = std::max(head.form, rise_of(shape));
  make_rectangle(shape);
  facing.edge().at = at;
}

// The sides at which two openings overlap: along the axis on which they overlap less.
std::optional<Overlap> overlap_of(ElementCandidate& a, ElementCandidate& b) {
  const Box2 p = a.shape.extent(), q = b.shape.extent();
  const double across = std::min(p.u1, q.u1) - std::max(p.u0, q.u0), up = std::min(p.v1, q.v1) - std::max(p.v0, q.v0);
  if (across <= kTouch || up <= kTouch || common_area(p, q) > kMostOfSmaller * std::min(area_of(p), area_of(q)))
    return std::nullopt;
  const bool beside = across < up;
  const bool in_order = beside ? p.u0 + p.u1 < q.u0 + q.u1 : p.v0 + p.v1 < q.v0 + q.v1;
  ElementCandidate &first = in_order ? a : b, &second = in_order ? b : a;
  const Side end = beside ? Side::right : Side::top, begin = beside ? Side::left : Side::bottom;
  return Overlap{{first, end}, {second, begin}};
}

void for_each_overlap(std::vector<ElementCandidate>& candidates, const std::function<void(const Overlap&)>& visit) {
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      ElementCandidate &a = candidates[i], &b = candidates[k];
      if (!is_opening(a.kind) || !is_opening(b.kind) || a.possible || b.possible) continue;
      if (const std::optional<Overlap> overlap = overlap_of(a, b)) visit(*overlap);
    }
}

}  // namespace

void open_overlapping_sides(std::vector<ElementCandidate>& candidates) {
  for_each_overlap(candidates, [](const Overlap& o) {
    const bool first = is_worse(o.first, o.second);
    const Facing& worse = first ? o.first : o.second;
    LocatedEdge& edge = worse.edge();
    const double most = (first ? o.second : o.first).edge().at, out = outwards(worse.side), was = edge.at;
    double least = edge.status == DrawnStatus::seen ? was - out * stated_error(edge) : edge.inner;
    if (out * (most - least) < 0) least = most;
    const double half = out * (most - least) / 2;
    move_side(worse, least + out * half);
    edge.error = std::max(half, std::min(stated_error(edge), out * (was - most)));
    edge.inner = least;
    edge.form = 0, edge.by_face = false, edge.status = DrawnStatus::occluded;
  });
}

void end_before_others(std::vector<ElementCandidate>& candidates) {
  for_each_overlap(candidates, [](const Overlap& o) {
    const LocatedEdge &a = o.first.edge(), &b = o.second.edge();
    const bool unseen = a.status != DrawnStatus::seen && b.status != DrawnStatus::seen;
    const double middle = (a.at + b.at) / 2;
    const auto end_at = [](const Facing& facing, double at) {
      LocatedEdge& edge = facing.edge();
      edge.error = std::max(edge.error, std::abs(edge.at - at));
      move_side(facing, at);
    };
    if (unseen) {
      end_at(o.first, middle), end_at(o.second, middle);
    } else if (is_worse(o.first, o.second)) {
      end_at(o.first, b.at);
    } else {
      end_at(o.second, a.at);
    }
  });
}

bool reaches_into_other(const std::vector<ElementCandidate>& candidates, std::size_t i, Side side, double at) {
  FoundRectangle own = candidates[i].shape;
  own.side(side).at = at;
  const Box2 box = own.extent().grown(-kTouch);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (k == i || !is_opening(candidates[k].kind)) continue;
    FoundRectangle other = candidates[k].shape;
    for (LocatedEdge& edge : other.sides)
      if (edge.status == DrawnStatus::occluded) edge.at = edge.inner;
    if (common_area(box, other.box()) > 0 && common_area(candidates[i].shape.box(), other.box()) == 0) return true;
  }
  return false;
}

}  // namespace ilot
