// SPDX-License-Identifier: Apache-2.0
// The faces between the outline of an element in the wall and its end before or behind the wall [Lorraine thesis,
// 4.2.1].
#pragma once
#include <array>
#include <cstddef>

#include "engine/model/facade.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

// `outline` has the sides where they meet the wall; `end` has the sides at the depth of the element. For each side
// there is a bound on its place in the outline from the points on that face, their root mean square distance and their
// number. A side without points has no bound.
struct SideFaces {
  Box2 outline, end;
  std::array<double, 4> error{}, rms{};
  std::array<std::size_t, 4> points{};
};

// A face is a line through its points, seen along itself and fitted by least squares. It leans if its points reach from
// the side of the outline to the side of the end, as in a bay window or a splayed reveal. Otherwise the end is the
// outline carried over, whatever part of it was seen. `outline` and `end` are known to about one cell. The outline is
// given as it is at the wall, or at `seen_at` out of it: a leaning side has moved in between. O(n) in the points
// around.
SideFaces side_faces(const RaySamples& samples, const Box2& outline, const Box2& end, double depth, double seen_at = 0);

// The closed body between two rectangles parallel to the wall, in metres in its axes. The faces are oriented outwards.
// An end narrower than a centimetre becomes an edge; an end that is narrower in both directions becomes a corner.
FacadeBody body_between(const FacadeSite& site, const Box2& outline, double at, const Box2& end, double end_at);

}  // namespace ilot
