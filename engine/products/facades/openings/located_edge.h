// SPDX-License-Identifier: Apache-2.0
// Exactly where the four sides of something on a facade lie.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/model/facade.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// Of a rectangle with sides along the wall's axes, in the order of the edges of its ring, counter-clockwise from the
// lower left corner.
enum class Side : std::uint8_t { bottom, right, top, left };
inline constexpr std::array kSides{Side::bottom, Side::right, Side::top, Side::left};

struct LocatedEdge {
  double at = 0;     // u of left and right, v of bottom and top
  double error = 0;  // it lies within this of `at` [Lorraine thesis, 4.3]
  DrawnStatus status = DrawnStatus::seen;
  std::uint64_t points = 0;
  double rms = 0;        // of these to the edge
  double moved = 0;      // by regularisation
  double inner = 0;      // of an edge that is not seen: the last place that is known to lie inside
  bool by_face = false;  // from points on the side face itself: the reveal, the side of a sill
};

struct SideSearch {
  Box2 box;                               // about where it lies
  double depth = 0;                       // w of the plane that ends, or begins, at the sides
  double epsilon = 0.005;                 // metres; of that plane
  bool hole = true;                       // the plane is around it (an opening); false: it is the thing itself (a sill)
  double face_from = 0, face_to = 0;      // w between which side faces may have points
  double reach = 0.15;                    // metres to either side of the box's sides that are searched
  std::span<const std::uint32_t> planes;  // of a thing: ids of its segments, ascending
};

// Between what is solid at the depth and where rays go through lies the edge (split_edge, half a step where rays come
// in columns [Lorraine thesis, 4.3]). Where points lie on the side face, square to the wall, these tell it: their line,
// extended to the plane. A gap of several steps that nothing was seen in is a laser shadow: the edge is `occluded`, its
// error is the gap. O(n log n) in the points around.
LocatedEdge locate_edge(const RaySamples& samples, const SideSearch& search, Side side);

}  // namespace ilot
