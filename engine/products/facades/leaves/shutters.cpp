// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/shutters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace ilot {
namespace {

// Choice: hinges hold a leaf up to 2 cm beside the jamb, 1 cm in the mean; as kHinge in openings.cpp.
constexpr double kHingeError = 0.01;  // metres between the ends of closed leaves and those of their window
// Choice: leaves overlap the reveal or end before it by as much.
constexpr double kHingeReach = 0.05;  // metres between an open leaf and its opening
// Derived: more than half.
constexpr double kOver = 0.5;  // share of a plate that an opening takes, or of a height that is seen
// Choice: windows of one row differ in width; an open leaf of a pair has half the width of its window.
constexpr double kWidthOfRow = 1.5;  // times the width of another window of its row, or that part of it
// Choice: a leaf closes half of its window, or less on a narrow pier.
constexpr double kLeastBetweenLeaves = 1, kMostBetweenLeaves = 4;  // widths of a leaf between the two of a window
// Derived: a majority; between two plates there may be another one of which something hides a part.
constexpr double kMostRelief = 0.5;  // share of a window between open leaves before which something stands
// Choice: lower plates without any opening beside them may be quoins, signs and panels.
constexpr double kLeastAlone = 0.8;  // metres, height
// Choice: two alike are a pair of boards; three are a row of windows.
constexpr std::size_t kFewestAlone = 3;
// Choice: a lintel and a sill; quoins and panels follow each other closer.
constexpr double kLeastBetween = 0.3;  // metres between windows of one column

double overlap_of(double a0, double a1, double b0, double b1) {
  return std::min(a1, b1) - std::max(a0, b0);
}

double area_in_common(const Box2& a, const Box2& b) {
  return std::max(0.0, overlap_of(a.u0, a.u1, b.u0, b.u1)) * std::max(0.0, overlap_of(a.v0, a.v1, b.v0, b.v1));
}

// The height of an arch or a point over its jambs; 0 without one.
double rise_of(const FoundRectangle& o) {
  if (o.pointed) {
    const double to = o.box().width() / 2 - o.pointed->crown_u, beside = to - o.pointed->centre.u;
    const double radius = o.pointed->radius;
    const double at_jamb = radius > 0
                               ? o.pointed->centre.v + std::sqrt(std::max(0.0, radius * radius - beside * beside))
                               : o.pointed->right_slope * to;
    return std::max(0.0, -at_jamb);
  }
  if (!o.arc) return 0;
  const double half = o.box().width() / 2, radius = o.arc->radius;
  return radius - std::sqrt(std::max(0.0, radius * radius - half * half));
}

// Lays the arc of an opening over its jambs.
void set_arch(FoundRectangle& o, double spring, double rise) {
  const double half = o.box().width() / 2, radius = (rise * rise + half * half) / (2 * rise);
  o.arc->centre = {(o.at(Side::left) + o.at(Side::right)) / 2, spring + rise - radius};
  o.arc->radius = radius;
}

// The part of an opening that leaves can close: they end where an arch begins.
Box2 jambs_of(const FoundRectangle& o) {
  Box2 box = o.box();
  box.v1 -= rise_of(o);
  return box;
}

// Compares plates with openings and with each other.
class LeafJudge {
 public:
  LeafJudge(double alike, double cell) : alike_(alike), cell_(cell) {}

  bool is_open_leaf(const FlatPlate& plate, const FoundRectangle& o) const {
    const Box2 p = plate.shape.box(), b = jambs_of(o);
    const double gap = std::max(p.u0 - b.u1, b.u0 - p.u1);
    return std::abs(gap) <= std::max(kHingeReach, cell_) && p.width() <= b.width() + near(plate.shape, o, Side::left) &&
           same_heights(plate, o);
  }

  // Whether two plates are the open leaves of a window between them: they end at one height and not at wall there.
  bool are_about_window(const FlatPlate& left, const FlatPlate& right) const {
    const Box2 p = left.shape.box(), q = right.shape.box();
    const double between = q.u0 - p.u1, wider = std::max(p.width(), q.width());
    return between > kLeastBetweenLeaves * wider && between < kMostBetweenLeaves * wider &&
           !left.ends_at(Side::right) && !right.ends_at(Side::left) &&
           std::abs(p.v0 - q.v0) <= near(left.shape, right.shape, Side::bottom) &&
           std::abs(p.v1 - q.v1) <= near(left.shape, right.shape, Side::top);
  }

  // Whether a plate closes an opening that was found about it or through gaps of it.
  bool is_before(const FlatPlate& plate, const FoundRectangle& o) const {
    const Box2 p = plate.shape.box(), b = o.box();
    const double common = area_in_common(p, b);
    return common > kOver * p.width() * p.height() && common > kOver * b.width() * b.height() &&
           p.width() <= kWidthOfRow * b.width();
  }

  // Whether an opening is the light above closed leaves.
  bool is_light_above(const FlatPlate& plate, const FoundRectangle& o) const {
    const Box2 p = plate.shape.box(), b = o.box();
    return std::abs(b.v0 - p.v1) <= std::max(kHingeReach, 2 * cell_) + std::min(cell_, o.error(Side::bottom)) &&
           overlap_of(p.u0, p.u1, b.u0, b.u1) > kOver * std::max(p.width(), b.width()) && b.height() < p.height();
  }

  // Whether an opening lies so that a plate cannot be closed leaves: over it, or beside it without wall between.
  bool excludes(const FoundRectangle& o, const FlatPlate& plate) const {
    const Box2 p = plate.shape.box(), b = o.box(), about = b.grown(std::max(kHingeReach, cell_));
    return area_in_common(p, b) > 0 ||
           (overlap_of(p.v0, p.v1, b.v0, b.v1) > 0 && overlap_of(p.u0, p.u1, about.u0, about.u1) > 0);
  }

  bool is_like(const FlatPlate& plate, const FoundRectangle& o) const {
    return is_in_row(plate, o) || (same_column(plate.shape, o) && same_size(plate, o));
  }
  bool is_in_row(const FlatPlate& plate, const FoundRectangle& o) const {
    const double ratio = plate.shape.box().width() / o.box().width();
    return ratio < kWidthOfRow && ratio > 1 / kWidthOfRow && same_heights(plate, o);
  }

  bool are_alike(const FlatPlate& a, const FlatPlate& b) const {
    if (are_in_row(a, b))
      return std::abs(a.shape.box().width() - b.shape.box().width()) <= near(a.shape, b.shape, Side::left);
    return same_size(a, b.shape) && same_column(a.shape, b.shape);
  }
  bool are_in_row(const FlatPlate& a, const FlatPlate& b) const { return same_heights(a, b.shape); }

 private:
  // How far a side of one and the same side of another may lie apart where both are meant to be equal.
  double near(const FoundRectangle& a, const FoundRectangle& b, Side side) const {
    return alike_ + 2 * kHingeError + std::min(cell_, a.error(side)) + std::min(cell_, b.error(side));
  }
  // One of both ends may be hidden; then more than half of the height is seen, and the widths are equal.
  bool same_heights(const FlatPlate& a, const FoundRectangle& b) const {
    const Box2 p = a.shape.box(), q = jambs_of(b);
    const bool bottom = std::abs(p.v0 - q.v0) <= near(a.shape, b, Side::bottom);
    const bool top = std::abs(p.v1 - q.v1) <= near(a.shape, b, Side::top);
    if (bottom && top) return true;
    if (std::abs(p.width() - q.width()) > near(a.shape, b, Side::left) || p.height() < kOver * q.height()) return false;
    return (top && !a.ends_at(Side::bottom) && p.v0 > q.v0) || (bottom && !a.ends_at(Side::top) && p.v1 < q.v1);
  }
  bool same_column(const FoundRectangle& a, const FoundRectangle& b) const {
    const Box2 p = a.box(), q = b.box();
    return std::abs(p.u0 - q.u0) <= near(a, b, Side::left) && std::abs(p.u1 - q.u1) <= near(a, b, Side::right);
  }
  bool same_size(const FlatPlate& a, const FoundRectangle& b) const {
    const Box2 p = a.shape.box(), q = jambs_of(b);
    const double wider = p.width() - q.width(), higher = p.height() - q.height();
    return std::abs(wider) <= near(a.shape, b, Side::left) && std::abs(higher) <= near(a.shape, b, Side::top);
  }

  double alike_, cell_;
};

// Whether a plate that is like no opening may be closed leaves together with others.
bool stands_alone(const std::vector<FlatPlate>& plates, const std::vector<FoundRectangle>& openings, std::size_t i) {
  const Box2 p = plates[i].shape.box();
  if (p.height() < kLeastAlone || p.height() < p.width()) return false;
  if (std::count_if(kSides.begin(), kSides.end(), [&](Side s) { return plates[i].ends_at(s); }) < 3) return false;
  const auto is_close = [&](const FoundRectangle& o) {
    const Box2 b = o.box();
    return overlap_of(p.u0, p.u1, b.u0, b.u1) > 0 && overlap_of(p.v0, p.v1, b.v0, b.v1) > -kLeastBetween;
  };
  for (std::size_t k = 0; k < plates.size(); ++k)
    if (k != i && is_close(plates[k].shape)) return false;
  return std::none_of(openings.begin(), openings.end(), is_close);
}

// The window between two open leaves.
FoundRectangle window_between(const FlatPlate& left, const FlatPlate& right) {
  FoundRectangle window = left.shape;
  window.depth = window.depth_error = 0;
  window.points += right.shape.points;
  window.side(Side::left) = left.shape.side(Side::right), window.side(Side::right) = right.shape.side(Side::left);
  for (LocatedEdge& edge : window.sides) edge.error += kHingeError, edge.by_face = false;
  return window;
}

// Adds the windows between two open leaves through which no ray is known to have gone and before which nothing stands,
// and says which plates are leaves of them. Other plates may be closed leaves because they are like these windows. No
// leaf of theirs can be closed: it does not end at wall on their side.
std::vector<bool> add_windows_between(const FlatPlates& found, const LeafJudge& judge,
                                      std::vector<FoundRectangle>& openings) {
  const std::vector<FlatPlate>& plates = found.plates;
  std::vector<bool> is_leaf(plates.size(), false);
  for (std::size_t i = 0; i < plates.size(); ++i)
    for (std::size_t k = 0; k < plates.size(); ++k) {
      if (!judge.are_about_window(plates[i], plates[k])) continue;
      const FoundRectangle window = window_between(plates[i], plates[k]);
      const auto overlaps = [&](const FoundRectangle& o) { return area_in_common(window.box(), o.box()) > 0; };
      const auto lies_between = [&](const FlatPlate& p) { return overlaps(p.shape); };
      if (std::any_of(openings.begin(), openings.end(), overlaps) ||
          std::any_of(plates.begin(), plates.end(), lies_between) ||
          relief_share(found.relief, window.box()) > kMostRelief)
        continue;
      openings.push_back(window);
      is_leaf[i] = is_leaf[k] = true;
    }
  return is_leaf;
}

// The window behind a plate, with what is hidden of it from an opening that it is like.
FoundRectangle window_behind(const FlatPlate& plate, const FoundRectangle* like, double alike) {
  FoundRectangle window = plate.shape;
  window.depth = window.depth_error = 0;
  for (LocatedEdge& edge : window.sides) edge.error += kHingeError, edge.by_face = false;
  if (like == nullptr) return window;
  const Box2 q = jambs_of(*like);
  const auto complete = [&](Side side, double at) {
    const double was = window.at(side);
    if (plate.ends_at(side) || outwards(side) * (at - was) <= alike) return;
    LocatedEdge& edge = window.side(side);
    edge = {at, like->error(side) + kHingeError + alike, DrawnStatus::completed};
    edge.inner = was;
  };
  complete(Side::bottom, q.v0), complete(Side::top, q.v1);
  const double rise = rise_of(*like), spring = window.at(Side::top);
  if (rise <= alike) return window;
  window.arc = like->arc, window.pointed = like->pointed;
  if (window.arc) window.arc->error += alike, set_arch(window, spring, rise);
  LocatedEdge& crown = window.side(Side::top);
  crown = {spring + rise, like->error(Side::top) + kHingeError + alike, DrawnStatus::completed};
  crown.inner = spring;
  return window;
}

// The opening above closed leaves is the upper part of their window.
void extend_below(const FlatPlate& plate, FoundRectangle& o) {
  o.side(Side::bottom) = plate.shape.side(Side::bottom);
  o.side(Side::bottom).error += kHingeError;
  for (const Side side : {Side::left, Side::right}) {
    if (outwards(side) * (plate.shape.at(side) - o.at(side)) <= 0) continue;
    o.side(side) = plate.shape.side(side);
    o.side(side).error += kHingeError;
  }
  if (o.arc) set_arch(o, plate.shape.at(Side::top), o.at(Side::top) - plate.shape.at(Side::top));
}

// The closed plates, and the opening or the closed plate that each is like.
struct ClosedPlates {
  std::vector<bool> closed;
  std::vector<bool> lit;  // there is a light above it
  std::vector<std::optional<FoundRectangle>> like;
};

ClosedPlates closed_plates(const std::vector<FlatPlate>& plates, const std::vector<FoundRectangle>& openings,
                           const LeafJudge& judge) {
  ClosedPlates found{std::vector<bool>(plates.size(), false), std::vector<bool>(plates.size(), false), {}};
  found.like.resize(plates.size());
  std::vector<std::size_t> free, alone;
  for (std::size_t i = 0; i < plates.size(); ++i) {
    if (!plates[i].ends_at(Side::left) || !plates[i].ends_at(Side::right)) continue;  // the side of a hinge
    if (std::any_of(openings.begin(), openings.end(),
                    [&](const auto& o) { return judge.excludes(o, plates[i]) && !judge.is_light_above(plates[i], o); }))
      continue;
    free.push_back(i);
    for (const FoundRectangle& o : openings) {
      if (!judge.is_light_above(plates[i], o)) continue;
      found.closed[i] = found.lit[i] = true;
      found.like[i] = o;
      extend_below(plates[i], *found.like[i]);
    }
    if (found.closed[i]) continue;
    for (const FoundRectangle& o : openings) {
      if (found.closed[i] || !judge.is_like(plates[i], o)) continue;
      found.closed[i] = true;
      if (judge.is_in_row(plates[i], o)) found.like[i] = o;
    }
    if (!found.closed[i] && stands_alone(plates, openings, i)) alone.push_back(i);
  }
  for (const std::size_t i : alone) {
    std::size_t alike = 1;
    for (const std::size_t k : alone) alike += k != i && judge.are_alike(plates[i], plates[k]);
    found.closed[i] = alike >= kFewestAlone;
  }
  for (bool more = true; more;) {
    more = false;
    for (const std::size_t i : free)
      for (const std::size_t k : free)
        if (i != k && !found.closed[i] && found.closed[k] && judge.are_alike(plates[i], plates[k])) {
          found.closed[i] = more = true;
          if (judge.are_in_row(plates[i], plates[k])) found.like[i] = found.like[k] ? found.like[k] : plates[k].shape;
        }
  }
  return found;
}

// Sides of an opening that leaves hide in part are those of the leaves.
void widen(const FlatPlate& plate, FoundRectangle& o) {
  for (const Side side : kSides) {
    if (!plate.ends_at(side) || (side != Side::bottom && !o.is_rectangle())) continue;
    if (outwards(side) * (plate.shape.at(side) - o.at(side)) <= o.error(side)) continue;
    o.side(side) = plate.shape.side(side);
    o.side(side).error += kHingeError;
  }
}

}  // namespace

std::vector<ShutterLeaf> find_shutters(const FlatPlates& found, double alike, double cell,
                                       std::vector<FoundRectangle>& openings) {
  const std::vector<FlatPlate>& plates = found.plates;
  const LeafJudge judge(alike, cell);
  const std::vector<bool> about_window = add_windows_between(found, judge, openings);
  const ClosedPlates closed = closed_plates(plates, openings, judge);
  std::vector<ShutterLeaf> leaves;
  std::vector<FoundRectangle> windows;
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const FlatPlate& plate = plates[i];
    const auto before = std::find_if(openings.begin(), openings.end(),
                                     [&](const FoundRectangle& o) { return judge.is_before(plate, o); });
    if (closed.lit[i]) {
      leaves.push_back({plate.shape, LeafState::closed});
      // Another plate may have widened the light since.
      const auto light = std::find_if(openings.begin(), openings.end(),
                                      [&](const FoundRectangle& o) { return judge.is_light_above(plate, o); });
      if (light != openings.end()) extend_below(plate, *light);
    } else if (closed.closed[i]) {
      windows.push_back(window_behind(plate, closed.like[i] ? &*closed.like[i] : nullptr, alike));
      leaves.push_back({plate.shape, LeafState::closed});
    } else if (before != openings.end()) {
      leaves.push_back({plate.shape, LeafState::closed});
      widen(plate, *before);
    } else if (about_window[i] || std::any_of(openings.begin(), openings.end(),
                                              [&](const FoundRectangle& o) { return judge.is_open_leaf(plate, o); })) {
      leaves.push_back({plate.shape, LeafState::open});
    }
  }
  openings.insert(openings.end(), windows.begin(), windows.end());
  return leaves;
}

}  // namespace ilot
