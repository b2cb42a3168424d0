// SPDX-License-Identifier: Apache-2.0
// Plates that lie on a wall beside its openings: which are alike, and what a plate makes of an opening. Internal to
// leaves/.
#pragma once
#include <algorithm>
#include <cmath>

#include "engine/products/facades/leaves/flat_plates.h"
#include "engine/products/facades/openings/arched_top.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

// Choice: hinges hold a leaf up to 2 cm beside the jamb, 1 cm in the mean; as kHinge in openings.cpp.
inline constexpr double kHingeError = 0.01;  // metres between the ends of closed leaves and those of their window

// The length that two intervals have in common; negative where they are apart.
inline double overlap_of(double a0, double a1, double b0, double b1) {
  return std::min(a1, b1) - std::max(a0, b0);
}

// The part of an opening that leaves can close: they end where an arch begins.
inline Box2 jambs_of(const FoundRectangle& o) {
  Box2 box = o.box();
  box.v1 -= rise_of(o);
  return box;
}

// The window behind a plate, with its outline and no depth.
inline FoundRectangle outlined_by(const FlatPlate& plate) {
  FoundRectangle window = plate.shape;
  window.depth = window.depth_error = 0;
  for (LocatedEdge& edge : window.sides) edge.error += kHingeError, edge.by_face = false;
  return window;
}

// Sides of an opening that a plate hides in part are those of the plate.
inline void widen(const FlatPlate& plate, FoundRectangle& o) {
  for (const Side side : kSides) {
    if (!plate.ends_at(side) || (side != Side::bottom && !o.is_rectangle())) continue;
    if (outwards(side) * (plate.shape.at(side) - o.at(side)) <= o.error(side)) continue;
    o.side(side) = plate.shape.side(side);
    o.side(side).error += kHingeError;
  }
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
    const double common = common_area(p, b);
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
    return common_area(p, b) > 0 ||
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

  // Whether a plate has the size of an opening, and its heights or its sides.
  bool is_as_large(const FlatPlate& plate, const FoundRectangle& o) const {
    return same_size(plate, o) && (same_heights(plate, o) || same_column(plate.shape, o));
  }

  // Whether panes, given by the rectangle around them, are those of a frame: they take its width.
  bool are_panes_of(const FlatPlate& frame, const FoundRectangle& panes) const {
    const Box2 p = frame.shape.box(), b = panes.box();
    return same_column(frame.shape, panes) && b.v0 >= p.v0 - near(frame.shape, panes, Side::bottom) &&
           b.v1 <= p.v1 + near(frame.shape, panes, Side::top);
  }

 private:
  double near(const FoundRectangle& a, const FoundRectangle& b, Side side) const {
    return equal_within(a, b, side, alike_ + 2 * kHingeError, cell_);
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

  // Choice: leaves overlap the reveal or end before it by as much.
  static constexpr double kHingeReach = 0.05;  // metres between an open leaf and its opening
  // Derived: more than half.
  static constexpr double kOver = 0.5;  // share of a plate that an opening takes, or of a height that is seen
  // Choice: windows of one row differ in width; an open leaf of a pair has half the width of its window.
  static constexpr double kWidthOfRow = 1.5;  // times the width of another window of its row, or that part of it
  // Choice: a leaf closes half of its window, or less on a narrow pier.
  static constexpr double kLeastBetweenLeaves = 1, kMostBetweenLeaves = 4;  // widths of a leaf between two of a window

  double alike_, cell_;
};

}  // namespace ilot
