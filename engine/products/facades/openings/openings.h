// SPDX-License-Identifier: Apache-2.0
// Finds windows and doors: places where rays go through the wall.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/products/facades/openings/silent_holes.h"
#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/rays/ray_samples.h"
#include "engine/products/facades/sides/located_edge.h"

namespace ilot {

struct OpeningParams {
  double least_size = 0.3;         // metres; a narrower or lower hole is no opening
  double least_depth = 0.04;       // metres; a hole whose end is less far behind the wall is no opening
  double shadow = 0.5;             // metres; parts of an opening are joined across shadows up to this width
  double room_depth = 4;           // metres; rays that end farther behind the wall are not used: rooms behind panes
  double room_depth_square = 2.5;  // metres; the same for rays that are taken to be perpendicular to the wall
  double hidden_above = 1.5;       // metres above an opening in which the wall must continue
  double arch_misfit = 0.35;       // residuals of a circle over those of a level line, at most
};

// A circle that is the upper end of an opening.
struct TopArc {
  Place2 centre;
  double radius = 0, rms = 0, error = 0;  // metres; the error is that of the circle as a whole
  double off = 0;                         // metres; the true edge is within this of the circle
  std::uint64_t points = 0;
};

// Two equal arcs, or two lines, that meet in the crown of an opening. Places are relative to the crown, so they follow
// the sides of the opening.
struct PointedTop {
  double crown_u = 0;                      // metres from the middle between the jambs to the crown
  double radius = 0;                       // metres, of both arcs; 0: lines
  Place2 centre;                           // of the right arc, from the crown; the left one is its mirror image
  double left_slope = 0, right_slope = 0;  // of the lines, dv / du
};

struct FoundRectangle {
  std::array<LocatedEdge, 4> sides;   // in the order of kSides
  double depth = 0, depth_error = 0;  // w of the surface in it; negative behind the wall
  std::uint64_t points = 0;           // number of rays through it, or of points on it
  std::uint32_t plane = 0;            // id of the plane, for an element in front of the wall
  double fill = 1;                    // share of its cells that contain such rays or points
  std::optional<TopArc> arc;          // its top side is then the crown
  std::optional<PointedTop> pointed;  // the same
  std::array<double, 4> lean{};       // tangents of its sides, as kSides; a leaning side has the place of its middle
  std::optional<Box2> end;            // its rectangle at its depth, where that differs from its own rectangle
  bool no_echo = false;               // an opening from which hardly any of the rays that crossed it came back
  bool few_echoes = false;            // a pane in the plane of the wall, known by the few rays that it sent back
  double at(Side s) const { return sides[static_cast<std::size_t>(s)].at; }
  double lean_of(Side s) const { return lean[static_cast<std::size_t>(s)]; }
  bool leans() const { return lean != std::array<double, 4>{}; }
  bool is_rectangle() const { return !arc && !pointed && !leans(); }
  double error(Side s) const { return sides[static_cast<std::size_t>(s)].error; }
  LocatedEdge& side(Side s) { return sides[static_cast<std::size_t>(s)]; }
  const LocatedEdge& side(Side s) const { return sides[static_cast<std::size_t>(s)]; }
  Box2 box() const { return {at(Side::left), at(Side::right), at(Side::bottom), at(Side::top)}; }
  // The box around its corners; that of a leaning side is at its middle.
  Box2 extent() const {
    const Box2 b = box();
    const auto beyond = [&](Side s, double length) { return std::abs(lean_of(s)) * length / 2; };
    return {b.u0 - beyond(Side::left, b.height()), b.u1 + beyond(Side::right, b.height()),
            b.v0 - beyond(Side::bottom, b.width()), b.v1 + beyond(Side::top, b.width())};
  }
};

// How far a side of one and the same side of another may lie apart where both are meant to be equal, in metres: `alike`
// and their errors, of which no more than `most_error` counts, as a side that is not known proves nothing.
inline double equal_within(const FoundRectangle& a, const FoundRectangle& b, Side side, double alike,
                           double most_error) {
  return alike + std::min(most_error, a.error(side)) + std::min(most_error, b.error(side));
}

// Takes away an arch, a point and leaning sides: what hides a part of an opening gives it such a form.
inline void make_rectangle(FoundRectangle& opening) {
  opening.arc.reset(), opening.pointed.reset();
  opening.lean = {};
}

// How far behind the wall a ray must end that goes through it, in metres.
double depth_through(const FacadeSite& site, const OpeningParams& params);

// Rays that end farther behind the wall are not used, in metres.
double farthest_in_room(const RaySamples& samples, const OpeningParams& params);

// The opening in a region of the cells of a wall through which rays go; no result if it is none. `silent` marks the
// cells that rays crossed without an echo. Points less than `through` behind the wall are not in it.
std::optional<FoundRectangle> opening_in(const RaySamples& samples, const WallCells& cells, const CellRegion& region,
                                         const std::vector<bool>& silent, double through, const OpeningParams& params);

// Takes the cells of the plane of the wall through which rays go and on which no point of the wall lies. They are
// joined over cells in which nothing was seen. A region that the wall bounds on both sides and above is an opening. The
// shadow of something in the street is no opening, because no ray goes through it. Holes with straight sides that free
// rays crossed without an echo count as cells through which rays go (find_holes). The order is from bottom to top, and
// from left to right within a row. Fills `steps`, and in `unseen` the holes that are no openings, where they are given.
// O(points).
std::vector<FoundRectangle> find_openings(const RaySamples& samples, const OpeningParams& params = {},
                                          OpeningSteps* steps = nullptr, std::vector<UnseenArea>* unseen = nullptr);

}  // namespace ilot
