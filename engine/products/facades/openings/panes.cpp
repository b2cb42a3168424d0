// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/panes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ilot {
namespace {

// Choice: the stiles where two casements meet are 10 to 15 cm wide together, casements 35 cm and wider.
constexpr double kBarShare = 0.43;  // share of the narrower pane that a bar takes at most
// Derived: a pier needs a cell of its own between the cells of its sides; of larger cells it looks like a bar.
constexpr double kCellsOfBar = 2;  // cells across the widest bar from which on panes are joined
// Choice: twice the error of an edge of 1 cm.
constexpr double kEqual = 0.03;  // metres between the ends of two panes of one window, at most
// Choice: bars take a tenth of a side and corners are rounded; a door beside a window with a sill leaves a third open.
constexpr double kSideCovered = 0.8;  // share of each side of a window along which its panes end
// Choice: bars of 15 cm between panes of half a metre leave three fifths.
constexpr double kPanesFill = 0.6;  // share of the window that its panes cover
// Derived: an opening that was found has half in common with the true one.
constexpr double kLeastOfRow = 0.5;  // height of panes over that of a window of their row

// The gap between two intervals; negative where they overlap.
double gap_between(double low_a, double high_a, double low_b, double high_b) {
  return std::max(low_a, low_b) - std::min(high_a, high_b);
}

// Whether no more than a bar parts two panes that lie side by side, or one above the other. Sides are searched in a
// strip that is wider than a bar, so that one may have been found beyond the bar: then the panes overlap.
bool is_bar(const Box2& p, const Box2& q, bool side_by_side) {
  const double gap = side_by_side ? gap_between(p.u0, p.u1, q.u0, q.u1) : gap_between(p.v0, p.v1, q.v0, q.v1);
  const double least = side_by_side ? std::min(p.width(), q.width()) : std::min(p.height(), q.height());
  return gap <= std::min(kWidestBar, kBarShare * least);
}

bool end_alike(const FoundRectangle& a, const FoundRectangle& b, Side side) {
  return std::abs(a.at(side) - b.at(side)) <= kEqual + a.error(side) + b.error(side);
}

// How panes are compared: whether both must end alike along a bar, whether a pier beside one would show, and whether
// panes with a head of their own may stand side by side.
struct PaneTest {
  bool end_together = true, piers_show = true, any_head = false;
};

// Whether there is no room for a pier between two panes that lie side by side, wherever their sides are within their
// errors. Where they overlap, their errors do not hold.
bool has_no_room_for_pier(const FoundRectangle& a, const FoundRectangle& b) {
  const bool first = a.at(Side::left) < b.at(Side::left);
  const FoundRectangle &left = first ? a : b, &right = first ? b : a;
  const double gap = right.at(Side::left) - left.at(Side::right),
               error = left.error(Side::right) + right.error(Side::left);
  return gap >= 0 && gap + error <= kWidestBar;
}

// Whether no more than a bar parts two openings along half of the shorter one. A pane with an arch or a point is the
// upper one of two.
bool touch_at_bar(const FoundRectangle& a, const FoundRectangle& b, PaneTest test) {
  const Box2 p = a.box(), q = b.box();
  const auto alike = [&](Side from, Side to) {
    return !test.end_together || (end_alike(a, b, from) && end_alike(a, b, to));
  };
  const bool rows = 2 * -gap_between(p.v0, p.v1, q.v0, q.v1) >= std::min(p.height(), q.height());
  const bool columns = 2 * -gap_between(p.u0, p.u1, q.u0, q.u1) >= std::min(p.width(), q.width());
  const bool straight = test.any_head || (a.is_rectangle() && b.is_rectangle());
  const FoundRectangle& lower = p.v0 < q.v0 ? a : b;
  const FoundRectangle& upper = p.v0 < q.v0 ? b : a;
  const bool headed = test.end_together && lower.is_rectangle() && !upper.leans();
  const bool no_pier = test.piers_show || has_no_room_for_pier(a, b);
  return (straight && no_pier && rows && is_bar(p, q, true) && alike(Side::bottom, Side::top)) ||
         ((straight || headed) && columns && is_bar(p, q, false) && alike(Side::left, Side::right));
}

// Each side is that of the pane farthest out, or of the better known one where both end alike. An arch or a point stays
// the head.
void join_pane(FoundRectangle& a, const FoundRectangle& b) {
  if (b.arc) a.arc = b.arc;
  if (b.pointed) a.pointed = b.pointed;
  for (const Side side : kSides) {
    const bool low = side == Side::left || side == Side::bottom;
    const double farther = low ? a.at(side) - b.at(side) : b.at(side) - a.at(side);
    const bool alike = std::abs(farther) <= a.error(side) + b.error(side);
    if (alike ? b.error(side) < a.error(side) : farther > 0) a.side(side) = b.side(side);
  }
  if (b.points > a.points) a.depth = b.depth, a.depth_error = b.depth_error;
  a.points += b.points;
  a.no_echo = a.no_echo && b.no_echo;
}

// The openings, and for each whether it is one without the others.
struct Panes {
  std::vector<FoundRectangle>& found;
  std::vector<bool> proven;

  void join(std::size_t into, std::size_t from) {
    join_pane(found[into], found[from]);
    proven[into] = proven[into] || proven[from];
  }
  void erase(std::size_t i) {
    found.erase(found.begin() + static_cast<std::ptrdiff_t>(i));
    proven.erase(proven.begin() + static_cast<std::ptrdiff_t>(i));
  }
};

void join_pairs(Panes& panes, bool piers_show) {
  const std::vector<FoundRectangle>& found = panes.found;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (std::size_t k = i + 1; k < found.size();) {
        if (!touch_at_bar(found[i], found[k], {true, piers_show})) {
          ++k;
          continue;
        }
        panes.join(i, k);
        panes.erase(k);
        more = true;
      }
  }
}

// The openings that bars connect with one of them, itself included; ascending.
std::vector<std::size_t> connected_by_bars(const std::vector<FoundRectangle>& found, std::size_t first, PaneTest test) {
  std::vector<std::size_t> members{first};
  for (std::size_t m = 0; m < members.size(); ++m)
    for (std::size_t k = 0; k < found.size(); ++k)
      if (std::find(members.begin(), members.end(), k) == members.end() &&
          touch_at_bar(found[members[m]], found[k], test))
        members.push_back(k);
  std::sort(members.begin(), members.end());
  return members;
}

// Whether some panes fill the rectangle around them: they end along each of its sides, with bars between them.
bool fill_rectangle(const std::vector<FoundRectangle>& found, const std::vector<std::size_t>& members,
                    const FoundRectangle& whole) {
  double area = 0;
  for (const std::size_t m : members) area += found[m].box().width() * found[m].box().height();
  if (area < kPanesFill * whole.box().width() * whole.box().height()) return false;
  return std::all_of(kSides.begin(), kSides.end(), [&](Side side) {
    const bool upright = side == Side::left || side == Side::right;
    double covered = 0;
    for (const std::size_t m : members)
      if (end_alike(found[m], whole, side)) covered += upright ? found[m].box().height() : found[m].box().width();
    return covered >= kSideCovered * (upright ? whole.box().height() : whole.box().width());
  });
}

// The window that some panes are together.
FoundRectangle joined(const std::vector<FoundRectangle>& found, const std::vector<std::size_t>& members) {
  FoundRectangle whole = found[members.front()];
  for (const std::size_t m : members)
    if (m != members.front()) join_pane(whole, found[m]);
  return whole;
}

void join_grids(Panes& panes, bool piers_show) {
  std::vector<FoundRectangle>& found = panes.found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<std::size_t> members = connected_by_bars(found, i, {false, piers_show});
    if (members.size() < 3 || members.front() < i) continue;  // two are a pair; others were looked at before
    const FoundRectangle whole = joined(found, members);
    if (!fill_rectangle(found, members, whole)) continue;
    for (const std::size_t m : members) panes.proven[i] = panes.proven[i] || panes.proven[m];
    found[i] = whole;
    for (std::size_t m = members.size(); m-- > 1;) panes.erase(members[m]);
  }
}

double near(const FoundRectangle& a, const FoundRectangle& b, Side side, double alike) {
  return equal_within(a, b, side, alike, kWidestBar);
}

bool is_same_side(const FoundRectangle& a, const FoundRectangle& b, Side side, double alike) {
  return std::abs(a.at(side) - b.at(side)) <= near(a, b, side, alike);
}

bool is_same_length(double a, double b, const FoundRectangle& p, const FoundRectangle& q, Side side, double alike) {
  return std::abs(a - b) <= near(p, q, side, alike);
}

// Whether a window has the place and the size of another one of its column.
bool is_like_in_column(const FoundRectangle& window, const FoundRectangle& other, double alike) {
  return is_same_side(window, other, Side::left, alike) && is_same_side(window, other, Side::right, alike) &&
         is_same_length(window.box().height(), other.box().height(), window, other, Side::top, alike);
}

// Whether a window has the width and the heights of another one of its row; one of its ends may lie within the other.
bool is_like_in_row(const FoundRectangle& window, const FoundRectangle& other, double alike) {
  const Box2 p = window.box(), q = other.box();
  if (!is_same_length(p.width(), q.width(), window, other, Side::right, alike)) return false;
  const bool foot = is_same_side(window, other, Side::bottom, alike),
             head = is_same_side(window, other, Side::top, alike);
  const bool within = p.v0 > q.v0 - near(window, other, Side::bottom, alike) &&
                      p.v1 < q.v1 + near(window, other, Side::top, alike) && p.height() >= kLeastOfRow * q.height();
  return (foot && head) || (within && (foot || head));
}

// The ends of a window that lie within another one of its row are hidden: the gap of each reaches to that of the other.
void open_ends(const FoundRectangle& other, double alike, FoundRectangle& window) {
  for (const Side side : {Side::bottom, Side::top}) {
    const double short_of = outwards(side) * (other.at(side) - window.at(side));
    if (short_of <= near(window, other, side, alike)) continue;
    LocatedEdge& edge = window.side(side);
    edge.inner = window.at(side);
    edge.at += outwards(side) * short_of / 2;
    edge.error = short_of / 2;
    edge.form = 0, edge.by_face = false, edge.status = DrawnStatus::occluded;
  }
}

// The opening that some panes are like together; none if more of the others are like one of the panes alone, of which
// each window that is parted has two. Of several in the row it is the highest, as others may lack a light too.
const FoundRectangle* window_like(const FoundRectangle& whole, const std::vector<FoundRectangle>& found,
                                  const std::vector<std::size_t>& members, double alike) {
  const FoundRectangle* like = nullptr;
  std::size_t as_whole = 0, as_pane = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (std::binary_search(members.begin(), members.end(), k)) continue;
    as_pane += std::any_of(members.begin(), members.end(), [&](std::size_t m) {
      return is_like_in_row(found[m], found[k], alike) || is_like_in_column(found[m], found[k], alike);
    });
    const bool row = is_like_in_row(whole, found[k], alike);
    if (!found[k].is_rectangle() || (!row && !is_like_in_column(whole, found[k], alike))) continue;
    ++as_whole;
    if (like == nullptr || (row && found[k].box().height() > like->box().height())) like = &found[k];
  }
  return as_pane <= 2 * as_whole ? like : nullptr;
}

}  // namespace

void join_panes_like_others(double alike, std::vector<FoundRectangle>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<std::size_t> members = connected_by_bars(found, i, {false, true, true});
    if (members.size() < 2 || members.front() < i) continue;
    FoundRectangle whole = joined(found, members);
    const FoundRectangle* like = window_like(whole, found, members, alike);
    if (like == nullptr) continue;
    make_rectangle(whole);  // what hangs behind a pane gives it a head of its own
    if (is_like_in_row(whole, *like, alike)) open_ends(*like, alike, whole);
    found[i] = whole;
    for (std::size_t m = members.size(); m-- > 1;) found.erase(found.begin() + static_cast<std::ptrdiff_t>(members[m]));
  }
}

void join_panes(double cell, std::size_t proven, std::vector<FoundRectangle>& found) {
  const bool piers_show = kCellsOfBar * cell <= kWidestBar;
  Panes panes{found, std::vector<bool>(found.size(), false)};
  std::fill(panes.proven.begin(), panes.proven.begin() + static_cast<std::ptrdiff_t>(proven), true);
  join_pairs(panes, piers_show);
  join_grids(panes, piers_show);
  for (std::size_t i = found.size(); i-- > 0;)
    if (!panes.proven[i]) panes.erase(i);
}

}  // namespace ilot
