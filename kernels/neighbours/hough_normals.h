// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/neighbours/normals.h"

namespace ilot {

struct HoughNormalsParams {
  int k = 30;                   // neighbours, the point itself included; 3 to kMaxNeighbours
  std::int64_t max_d2 = 0;      // squared units: neighbours lie within this
  double confidence = 0.95;     // with this probability every bin's share of the triplets drawn ...
  double max_deviation = 0.08;  // ... is within this of its share of all triplets; at least 0.05
};

// Normals that stay sharp at edges [D2, Boulch and Marlet 2012]: triplets of the k nearest neighbours each vote with
// the normal of their plane, and the leading bin of a spherical accumulator wins, where principal components would
// average over both faces. The accumulator is a cube of 3 x 8 x 8 bins (11 degrees) for directions without sign, in
// five fixed rotations, so that one of them has the mode well inside a bin. As many triplets are drawn as Hoeffding's
// bound asks for (700 by default, 2,048 at most, never one twice); drawing stops when in one rotation the leading bin
// is significantly ahead of the next. The answer is the area-weighted mean of the votes within 10 degrees, twice, from
// the leading bin's centre on. Curvature is that of the principal components (normals.h); the normal is none where
// theirs is. Draws are keyed by the neighbours' positions relative to the query, so the bits depend on nothing else.
// reach2 as in knn(). About 2.5 microseconds a point.
void hough_normals(const NeighbourIndex& index, std::span<const std::uint32_t> queries,
                   const HoughNormalsParams& params, std::span<PackedNormal> out, std::span<std::int64_t> reach2);

}  // namespace ilot
