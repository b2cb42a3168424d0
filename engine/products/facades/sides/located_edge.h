// SPDX-License-Identifier: Apache-2.0
// Finds the exact places of the four sides of a facade element.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/model/facade.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// The sides of a rectangle along the axes of the wall, in the order of the edges of its ring: counter-clockwise from
// the lower left corner.
enum class Side : std::uint8_t { bottom, right, top, left };
inline constexpr std::array kSides{Side::bottom, Side::right, Side::top, Side::left};

// Whether a side is known by its place along u.
inline bool along_u(Side side) {
  return side == Side::left || side == Side::right;
}

// The sign of the direction out of a rectangle at a side, along the axis of its place.
inline double outwards(Side side) {
  return side == Side::right || side == Side::top ? 1 : -1;
}

struct LocatedEdge {
  double at = 0;     // u of left and right, v of bottom and top
  double error = 0;  // the true place is within this distance of `at` [Lorraine thesis, 4.3]
  DrawnStatus status = DrawnStatus::seen;
  std::uint64_t points = 0;
  double form = 0;   // what its drawn form is off by, which is no error of measurement: cut corners drawn level. Edges
                     // are compared with each other by their error, and the larger of both is stated
  double rms = 0;    // root mean square distance of these points to the edge
  double moved = 0;  // distance by which regularisation moved it
  double inner = 0;  // for an edge that is not seen: the last place that is known to be inside
  // Of an edge of which nothing was seen: metres from `inner` to where the wall is seen; 0: not known.
  double beyond = 0;
  bool by_face = false;  // found from points on the side face itself: the reveal, the side of a sill
};

struct SideSearch {
  Box2 box;                // its approximate place
  double depth = 0;        // w of the plane that ends or begins at the sides
  double epsilon = 0.005;  // metres; epsilon of that plane
  bool hole = true;        // true: the plane is around it (an opening); false: the plane is the element itself (a sill)
  double face_from = 0, face_to = 0;      // values of w between which side faces may have points
  double reach = 0.15;                    // metres on either side of the sides of the box that are searched
  std::span<const std::uint32_t> planes;  // of an element that is a surface itself: ids of its segments, ascending
  bool silent = false;  // rays that cross a hole without an echo are known to be free: it begins where the wall ends
};

// The edge is between what is solid at the depth and the rays that go through (split_edge; half a step where rays come
// in columns [Lorraine thesis, 4.3]). Where points lie on the side face, which is perpendicular to the wall, they give
// the edge: their line is extended to the plane. A gap of several steps in which nothing was seen is a laser shadow.
// Then the edge is `occluded` and its error is the gap; but a hole without an echo begins where the scan lines end. O(n
// log n) in the points around.
LocatedEdge locate_edge(const RaySamples& samples, const SideSearch& search, Side side);

}  // namespace ilot
