// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/regular_facade.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/products/facades/elements/element_kinds.h"
#include "engine/products/facades/elements/separate_openings.h"
#include "kernels/core/quantile.h"
#include "kernels/outlines/agreement.h"

namespace ilot {
namespace {

// Choice: three times the error of an edge of 1 cm; a sill that projects farther beyond its shadow is not used.
constexpr double kBesideShadow = 0.03;  // metres beyond a gap in which the top of a sill may be
// Choice: a sill of 20 cm seen at 70 degrees hides 55 cm above it; steeper rays hide more.
constexpr double kHighestShadow = 0.6;  // metres above its top that a sill hides

// Derived: an opening that was found has half in common with the true one. Of two rectangles, one within the other, the
// smaller one is the share of the larger one that they have in common.
constexpr double kMostSeen = 0.5;  // share of the larger of two openings, one within the other, that the smaller one is

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

// A quantile of the chi-square distribution, by that of the normal distribution [Wilson and Hilferty 1931].
double chi_square(double freedom, double normal_quantile) {
  const double part = 2 / (9 * freedom), root = 1 - part + normal_quantile * std::sqrt(part);
  return freedom * std::max(0.0, root * root * root);
}
// Derived: 10 % and 95 % of the normal distribution.
constexpr double kLow = -1.2816, kHigh = 1.6449;

// How far measurements that may be of one value lie apart.
struct Scatter {
  double squares = 0;   // of their distances from their mean
  double expected = 0;  // what these would be if only the measurements were wrong
  double freedom = 0;   // number of measurements less one

  void add(const Scatter& o) { squares += o.squares, expected += o.expected, freedom += o.freedom; }
};

// An error is a bound within which the true value may be anywhere: its variance is a third of its square.
Scatter scatter_of(const std::vector<Bounded>& measured) {
  double mean = 0, variance = 0, squares = 0;
  const auto count = static_cast<double>(measured.size());
  for (const Bounded& m : measured) mean += m.value / count, variance += m.error * m.error / 3 / count;
  for (const Bounded& m : measured) squares += (m.value - mean) * (m.value - mean);
  return {squares, (count - 1) * variance, count - 1};
}

// Whether the measurements prove that the values are equal up to less than what each measurement is wrong by: by 90 %
// confidence, the values scatter so little that a common value is nearer to the truth than the measurements are.
bool is_proof(const Scatter& s) {
  return s.freedom > 0 && s.squares * s.freedom <= 2 * s.expected * chi_square(s.freedom, kLow);
}
bool may_be_equal(const Scatter& s) {
  return s.freedom > 0 && s.squares * s.freedom <= s.expected * chi_square(s.freedom, kHigh);
}

// Measurements of one quantity of several elements, and those of them that may be equal.
struct MeasuredGroup {
  Members members;
  std::vector<Bounded> measured;
  std::vector<std::size_t> equal;

  std::vector<Bounded> of_equal() const {
    std::vector<Bounded> values;
    for (const std::size_t i : equal) values.push_back(measured[i]);
    return values;
  }
};

// Leaves out the members farthest from the middle, one after the other, until the rest may be equal; all of them if
// more than a fifth would be left out.
void leave_out_others(MeasuredGroup& group) {
  constexpr double kLeftOut = 0.2;  // Choice: one window in five is a later one
  group.equal.clear();
  for (std::size_t i = 0; i < group.measured.size(); ++i) group.equal.push_back(i);
  const auto least = std::max(2.0, static_cast<double>(group.measured.size()) * (1 - kLeftOut));
  while (static_cast<double>(group.equal.size()) >= least) {
    const std::vector<Bounded> left = group.of_equal();
    if (may_be_equal(scatter_of(left))) return;
    std::vector<double> values;
    for (const Bounded& m : left) values.push_back(m.value);
    const double middle = upper_median(values);
    group.equal.erase(std::max_element(group.equal.begin(), group.equal.end(), [&](std::size_t a, std::size_t b) {
      const double va = group.measured[a].value, vb = group.measured[b].value;
      const double da = std::abs(va - middle), db = std::abs(vb - middle);
      return da != db ? da < db : va < vb;
    }));
  }
  group.equal.clear();
}

// Gives each group that is proved to be equal its common value: all groups together where they prove it together, as
// the columns of one front do, otherwise each one that proves it alone.
void make_equal(std::vector<MeasuredGroup>& groups,
                const std::function<void(const MeasuredGroup&, const Bounded&)>& move) {
  Scatter all;
  for (MeasuredGroup& group : groups) {
    leave_out_others(group);
    if (group.equal.size() > 1) all.add(scatter_of(group.of_equal()));
  }
  for (const MeasuredGroup& group : groups)
    if (group.equal.size() > 1 && (is_proof(all) || is_proof(scatter_of(group.of_equal()))))
      move(group, agreement(group.of_equal()));
}

// Moves one side of all members that are proved to be in line onto one line. No edge moves farther than its error, in
// all its moves together.
void align(const std::vector<Members>& lines, Side side) {
  std::vector<MeasuredGroup> groups;
  for (const Members& members : lines) {
    MeasuredGroup& group = groups.emplace_back();
    for (ElementCandidate* t : members)
      if (seen(*t, side))
        group.members.push_back(t), group.measured.push_back({t->shape.at(side), t->shape.error(side)});
  }
  make_equal(groups, [&](const MeasuredGroup& group, const Bounded& common) {
    for (const std::size_t i : group.equal) {
      LocatedEdge& edge = group.members[i]->shape.side(side);
      if (edge.moved + std::abs(edge.at - common.value) <= edge.error) move_to(edge, common.value);
    }
  });
}

// Makes the distance between two sides equal for all members for which it is proved to be. Each side moves by its share
// of the errors.
void equalise(const std::vector<Members>& families, Side low, Side high) {
  std::vector<MeasuredGroup> groups;
  for (const Members& members : families) {
    MeasuredGroup& group = groups.emplace_back();
    for (ElementCandidate* t : members) {
      if (!seen_across(*t, low, high)) continue;
      const double ea = t->shape.error(low), eb = t->shape.error(high);
      group.members.push_back(t);
      group.measured.push_back({t->shape.at(high) - t->shape.at(low), std::sqrt(ea * ea + eb * eb)});
    }
  }
  make_equal(groups, [&](const MeasuredGroup& group, const Bounded& common) {
    for (const std::size_t i : group.equal) {
      LocatedEdge &a = group.members[i]->shape.side(low), &b = group.members[i]->shape.side(high);
      const double missing = common.value - (b.at - a.at), both = a.error + b.error;
      if (!(both > 0)) continue;
      const double move_a = missing * a.error / both, move_b = missing * b.error / both;
      if (a.moved + std::abs(move_a) > a.error || b.moved + std::abs(move_b) > b.error) continue;
      move_to(a, a.at - move_a);
      move_to(b, b.at + move_b);
    }
  });
}

// The error of a side that nobody saw and that was given a place: it may be anywhere from the last place that was seen
// to be open to the first place that was seen to be wall.
double unseen_error(const LocatedEdge& gap, double at) {
  const double far = gap.at + (gap.at - gap.inner);
  const double end = std::abs(gap.at - gap.inner) < gap.error / 2 ? gap.error : std::abs(far - at);
  return std::max(std::abs(at - gap.inner), end);
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
    bottom.error = std::max(sill.shape.error(Side::top), std::abs(bottom.inner - top));
    bottom.at = top;
    bottom.status = DrawnStatus::completed;
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
bool complete_from_row(ElementCandidate& t, std::size_t i, const std::vector<ElementCandidate>& candidates, Side side,
                       const RegularParams& params) {
  std::vector<Bounded> bounds;
  LocatedEdge& edge = t.shape.side(side);
  for (const ElementCandidate& other : candidates)
    if (other.kind == t.kind && other.row == t.row && seen(other, side) &&
        std::abs(other.shape.at(side) - edge.at) <= edge.error + params.alike &&
        allowed(edge, side, other.shape.at(side), params))
      bounds.push_back({other.shape.at(side), other.shape.error(side)});
  if (t.row == 0 || bounds.empty()) return false;
  const Bounded common = agreement(bounds);
  if (reaches_into_other(candidates, i, side, common.value)) return false;
  edge.error = std::max(common.error + params.alike / 4, unseen_error(edge, common.value));
  edge.at = common.value;
  edge.status = DrawnStatus::completed;
  t.reason = "sides that are hidden come from its row";
  return true;
}

// Completes a side from the side that is seen and the size of others: first those of its row, then the rest.
bool complete_from_size(ElementCandidate& t, std::size_t i, const std::vector<ElementCandidate>& candidates, Side side,
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
  const double at = t.shape.at(other_side) + (side == high ? common.value : -common.value);
  if (reaches_into_other(candidates, i, side, at)) return false;
  edge.error = std::max(t.shape.error(other_side) + common.error, unseen_error(edge, at));
  edge.at = at;
  edge.status = DrawnStatus::completed;
  t.reason = "sides that are hidden come from others of its size";
  return true;
}

// The gap in which a side is that nobody saw, from the last place that was seen to be open on; 0 where it has no end.
double gap_of(const LocatedEdge& edge) {
  return edge.at == edge.inner ? edge.beyond : unseen_error(edge, edge.inner);
}

// Places the sides of an opening of which nothing else is known than their gaps.
void place_hidden(ElementCandidate& t, const std::vector<Side>& hidden) {
  bool ends = true;
  double most_width = 0, most_height = 0;
  for (const Side side : hidden) {
    LocatedEdge& edge = t.shape.side(side);
    const double gap = gap_of(edge);
    ends &= gap > 0;
    (along_u(side) ? most_width : most_height) += gap;
    edge.error = gap > 0 ? gap : unseen_error(edge, edge.inner);
    edge.at = edge.inner;
  }
  t.reason = "sides end where a laser shadow begins";
  const double width = width_of(t), height = height_of(t);
  const double least = width * height, most = (width + most_width) * (height + most_height);
  if (!ends || !(most > 0) || least >= kMostSeen * most) return;
  const double middle = (width + most_width / 2) * (height + most_height / 2);
  t.possible = least < kMostSeen * middle || middle < kMostSeen * most;
  if (t.possible) return;
  for (const Side side : hidden) {
    LocatedEdge& edge = t.shape.side(side);
    edge.error /= 2;
    edge.at += outwards(side) * edge.error;
  }
  t.reason = "sides lie in the middle of a laser shadow";
}

// A bottom that nobody saw is no lower than the foot of the wall, where v is 0, or the lowest place that was seen to be
// open: where the ground rises, doors are not all of one height.
void end_at_foot(LocatedEdge& bottom) {
  const double lowest = std::min(bottom.inner, 0.0);
  if (bottom.status == DrawnStatus::seen || bottom.at >= lowest) return;
  bottom.at = lowest;
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
    for (const Side side : {Side::bottom, Side::top, Side::left, Side::right})
      align(grouped(
                kind, [&](const ElementCandidate& t) { return t.shape.at(side); }, params.alike),
            side);
    equalise(grouped(kind, width_of, params.alike), Side::left, Side::right);
    equalise(grouped(kind, height_of, params.alike), Side::bottom, Side::top);
  }
}

void complete_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params) {
  const std::vector<ElementCandidate> before = candidates;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ElementCandidate& t = candidates[i];
    if (!is_opening(t)) continue;
    std::vector<Side> hidden;
    for (const Side side : kSides) {
      LocatedEdge& edge = t.shape.side(side);
      if (side == Side::bottom && complete_from_sill(t, before)) continue;
      if (edge.status != DrawnStatus::occluded) continue;
      const bool level = side == Side::bottom || side == Side::top;
      if (level && complete_from_row(t, i, before, side, params)) continue;
      if (complete_from_size(t, i, before, side, params)) continue;
      hidden.push_back(side);
    }
    if (!hidden.empty()) place_hidden(t, hidden);
    end_at_foot(t.shape.side(Side::bottom));
  }
}

}  // namespace ilot
