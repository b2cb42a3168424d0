// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/regular_facade.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "kernels/outlines/agreement.h"

namespace ilot {
namespace {

// Choice: three times the error of an edge of 1 cm; a sill that projects farther beyond its shadow is not used.
constexpr double kBesideShadow = 0.03;  // metres beyond a gap in which the top of a sill may be
// Choice: a sill of 20 cm seen at 70 degrees hides 55 cm above it; steeper rays hide more.
constexpr double kHighestShadow = 0.6;  // metres above its top that a sill hides
// Choice: the value of element_kinds.cpp, where sills are found.
constexpr double kUnder = 0.7;  // share of the width of an opening that its sill covers

using Members = std::vector<ElementCandidate*>;

double width_of(const ElementCandidate& t) {
  return t.shape.at(Side::right) - t.shape.at(Side::left);
}
double height_of(const ElementCandidate& t) {
  return t.shape.at(Side::top) - t.shape.at(Side::bottom);
}
bool is_opening(const ElementCandidate& t) {
  return t.kind == ElementKind::window || t.kind == ElementKind::door;
}
// Whether the side is seen, so that it may be aligned with others. An element that leans stays as it is.
bool seen(const ElementCandidate& t, Side side) {
  return t.shape.side(side).status == DrawnStatus::seen && t.shape.lean_of(side) == 0;
}
bool seen_across(const ElementCandidate& t, Side low, Side high) {
  return seen(t, low) && seen(t, high);
}

std::vector<Members> by_kind(std::vector<ElementCandidate>& candidates) {
  std::vector<Members> kinds;
  for (ElementCandidate& t : candidates) {
    const auto of_kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const Members& m) { return m[0]->kind == t.kind; });
    (of_kind == kinds.end() ? *kinds.insert(kinds.end(), Members{}) : *of_kind).push_back(&t);
  }
  return kinds;
}

std::vector<Members> grouped(const Members& members, const std::function<double(const ElementCandidate&)>& value,
                             double tolerance) {
  std::vector<double> values;
  for (const ElementCandidate* t : members) values.push_back(value(*t));
  const std::vector<std::size_t> group = groups_of_equals(values, tolerance);
  std::vector<Members> groups(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) groups[group[i]].push_back(members[i]);
  std::erase_if(groups, [](const Members& m) { return m.empty(); });
  return groups;
}

void move_to(LocatedEdge& edge, double at) {
  edge.moved += std::abs(at - edge.at);
  edge.at = at;
}

// Moves one side of all members onto one line.
void align(const Members& members, Side side) {
  std::vector<Bounded> bounds;
  for (const ElementCandidate* t : members)
    if (seen(*t, side)) bounds.push_back({t->shape.at(side), t->shape.error(side)});
  if (bounds.size() < 2) return;
  const Bounded common = agreement(bounds);
  for (ElementCandidate* t : members) {
    LocatedEdge& edge = t->shape.side(side);
    if (!seen(*t, side) || std::abs(edge.at - common.value) > edge.error) continue;
    move_to(edge, common.value);
  }
}

// The error of a member's size when it comes from its family. It is at least the error of the most exact member, and at
// least the error of the common size. To this the part of the differences between the members is added that their own
// errors (as two deviations) do not explain.
double family_error(const Members& members, Side low, Side high, const Bounded& common) {
  double best = INFINITY, squares = 0, explained = 0, count = 0;
  for (const ElementCandidate* t : members) {
    if (!seen_across(*t, low, high)) continue;
    const double ea = t->shape.error(low), eb = t->shape.error(high);
    const double off = t->shape.at(high) - t->shape.at(low) - common.value;
    if (std::abs(off) > ea + eb) continue;
    best = std::min(best, std::sqrt(ea * ea + eb * eb));
    squares += off * off, explained += (ea * ea + eb * eb) / 4, count += 1;
  }
  return std::max(best, common.error) + 2 * std::sqrt(std::max(0.0, squares - explained) / std::max(1.0, count));
}

// Makes the distance between two sides equal for all members. Each side moves by its share of the errors.
void equalise(const Members& members, Side low, Side high) {
  std::vector<Bounded> bounds;
  for (const ElementCandidate* t : members)
    if (seen_across(*t, low, high))
      bounds.push_back({t->shape.at(high) - t->shape.at(low), t->shape.error(high) + t->shape.error(low)});
  if (bounds.size() < 2) return;
  const Bounded common = agreement(bounds);
  const double size_error = family_error(members, low, high, common);
  for (ElementCandidate* t : members) {
    LocatedEdge &a = t->shape.side(low), &b = t->shape.side(high);
    const double missing = common.value - (b.at - a.at), both = a.error + b.error;
    if (!seen_across(*t, low, high) || std::abs(missing) > both) continue;
    const double share = a.error / both;
    move_to(a, a.at - missing * share);
    move_to(b, b.at + missing * (1 - share));
    (low == Side::left ? t->shape.width_error : t->shape.height_error) = size_error;
    const double ea = a.error, eb = b.error;
    a.error = std::min(ea, eb + common.error);
    b.error = std::min(eb, ea + common.error);
  }
}

// Completes the bottom from the top of a sill, if this is within the gap of the bottom and is more exact: nothing
// behind a sill can be seen.
bool complete_from_sill(ElementCandidate& t, const std::vector<ElementCandidate>& candidates) {
  LocatedEdge& bottom = t.shape.side(Side::bottom);
  if (bottom.by_face) return false;
  for (const ElementCandidate& sill : candidates) {
    if ((sill.kind != ElementKind::sill && sill.kind != ElementKind::band) || !seen(sill, Side::top)) continue;
    const double common = std::min(t.shape.at(Side::right), sill.shape.at(Side::right)) -
                          std::max(t.shape.at(Side::left), sill.shape.at(Side::left));
    const double top = sill.shape.at(Side::top), below = bottom.inner - top;
    const double lowest = std::min(bottom.inner - bottom.at + bottom.error + kBesideShadow, kHighestShadow);
    if (common < kUnder * width_of(t) || below < -kBesideShadow || below > lowest) continue;
    if (sill.shape.error(Side::top) >= bottom.error) continue;
    bottom.at = top;
    bottom.error = sill.shape.error(Side::top);
    bottom.status = DrawnStatus::completed;
    t.shape.height_error = INFINITY;
    t.reason = "its bottom is hidden; it is the top of what stands before it, carried to the wall";
    return true;
  }
  return false;
}

// Whether a side may be at a place: it must not be inside of what was seen to be open.
bool allowed(const LocatedEdge& edge, Side side, double at, const RegularParams& params) {
  const bool low = side == Side::left || side == Side::bottom;
  return low ? at <= edge.inner + params.alike : at >= edge.inner - params.alike;
}

// Completes a side from members of the row whose side is seen.
bool complete_from_row(ElementCandidate& t, const std::vector<ElementCandidate>& candidates, Side side,
                       const RegularParams& params) {
  std::vector<Bounded> bounds;
  LocatedEdge& edge = t.shape.side(side);
  for (const ElementCandidate& other : candidates)
    if (other.kind == t.kind && other.row == t.row && &other != &t && seen(other, side) &&
        std::abs(other.shape.at(side) - edge.at) <= edge.error + params.alike &&
        allowed(edge, side, other.shape.at(side), params))
      bounds.push_back({other.shape.at(side), other.shape.error(side)});
  if (t.row == 0 || bounds.empty()) return false;
  const Bounded common = agreement(bounds);
  edge.at = common.value;
  edge.error = common.error + params.alike / 4;
  edge.status = DrawnStatus::completed;
  t.reason = "sides that are hidden come from its row";
  return true;
}

// Completes a side from the side that is seen and the size of others: first those of its row, then the rest.
bool complete_from_size(ElementCandidate& t, const std::vector<ElementCandidate>& candidates, Side side,
                        const RegularParams& params) {
  const bool across = side == Side::left || side == Side::right;
  const Side low = across ? Side::left : Side::bottom, high = across ? Side::right : Side::top;
  const Side other_side = side == low ? high : low;
  if (!seen(t, other_side)) return false;
  LocatedEdge& edge = t.shape.side(side);
  std::vector<Bounded> sizes, of_row;
  for (const ElementCandidate& other : candidates) {
    if (other.kind != t.kind || !seen_across(other, low, high)) continue;
    const double size = other.shape.at(high) - other.shape.at(low);
    const double at = t.shape.at(other_side) + (side == high ? size : -size);
    if (std::abs(at - edge.at) > edge.error + params.alike || !allowed(edge, side, at, params)) continue;
    sizes.push_back({size, other.shape.error(low) + other.shape.error(high)});
    if (other.row == t.row && t.row != 0) of_row.push_back(sizes.back());
  }
  if (sizes.empty()) return false;
  const Bounded common = agreement(of_row.empty() ? sizes : of_row);
  edge.at = t.shape.at(other_side) + (side == high ? common.value : -common.value);
  edge.error = t.shape.error(other_side) + common.error;
  edge.status = DrawnStatus::completed;
  t.reason = "sides that are hidden come from others of its size";
  return true;
}

}  // namespace

void group_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params) {
  std::uint32_t families = 0;
  const auto top = [](const ElementCandidate& t) { return t.shape.at(Side::top); };
  const auto middle = [](const ElementCandidate& t) { return (t.shape.at(Side::left) + t.shape.at(Side::right)) / 2; };
  for (const Members& kind : by_kind(candidates)) {
    std::uint32_t row = 0, column = 0;
    for (const Members& m : grouped(kind, top, params.line_up)) {
      ++row;
      for (ElementCandidate* t : m) t->row = row;
    }
    for (const Members& m : grouped(kind, middle, params.line_up)) {
      ++column;
      for (ElementCandidate* t : m) t->column = column;
    }
    for (const Members& wide : grouped(kind, width_of, params.alike))
      for (const Members& m : grouped(wide, height_of, params.alike)) {
        if (m.size() > 1) ++families;
        for (ElementCandidate* t : m) t->family = m.size() > 1 ? families : 0;
      }
  }
}

void regularise_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params) {
  for (const Members& kind : by_kind(candidates)) {
    for (const Side side : {Side::bottom, Side::top})
      for (const Members& m : grouped(
               kind, [&](const ElementCandidate& t) { return t.shape.at(side); }, params.alike))
        align(m, side);
    for (const Side side : {Side::left, Side::right})
      for (const Members& m : grouped(
               kind, [&](const ElementCandidate& t) { return t.shape.at(side); }, params.alike))
        align(m, side);
    for (const Members& m : grouped(kind, width_of, params.alike)) equalise(m, Side::left, Side::right);
    for (const Members& m : grouped(kind, height_of, params.alike)) equalise(m, Side::bottom, Side::top);
  }
}

void complete_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params) {
  const std::vector<ElementCandidate> before = candidates;
  for (ElementCandidate& t : candidates) {
    if (!is_opening(t)) continue;
    for (const Side side : kSides) {
      LocatedEdge& edge = t.shape.side(side);
      if (side == Side::bottom && complete_from_sill(t, before)) continue;
      if (edge.status != DrawnStatus::occluded) continue;
      const bool level = side == Side::bottom || side == Side::top;
      if (level && complete_from_row(t, before, side, params)) continue;
      if (complete_from_size(t, before, side, params)) continue;
      edge.at = edge.inner;
      t.reason = "sides end where a laser shadow begins";
    }
  }
}

}  // namespace ilot
