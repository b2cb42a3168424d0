// SPDX-License-Identifier: Apache-2.0
// The faces that join an element's outline in the wall to where it ends before or behind it [Lorraine thesis, 4.2.1].
#pragma once
#include <array>
#include <cstddef>

#include "engine/model/facade.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

// `outline`: the sides where they meet the wall; `end`: at the element's depth. By side: bound on the outline's place
// from the points on that face, their root mean square distance and number; no points, no bound.
struct SideFaces {
  Box2 outline, end;
  std::array<double, 4> error{}, rms{};
  std::array<std::size_t, 4> points{};
};

// A face is a line by least squares through its points, seen along itself. It leans where points lie on the face
// from the outline's side to the end's, as in a bay window or a splayed reveal; where they do not, the end is the
// outline carried over, whatever part of it was seen. `outline` and `end` are given to about a cell, the outline as it
// is at the wall or `seen_at` out of it: what leans has moved on the way. O(n) in the points around.
SideFaces side_faces(const RaySamples& samples, const Box2& outline, const Box2& end, double depth, double seen_at = 0);

// The closed body between two rectangles parallel to the wall, metres in its axes. Faces turn outwards. An end narrower
// than a centimetre is an edge, one narrower both ways a corner.
FacadeBody body_between(const FacadeSite& site, const Box2& outline, double at, const Box2& end, double end_at);

}  // namespace ilot
