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

// Computes normals that stay sharp at edges [D2, Boulch and Marlet 2012]. Triplets of the k nearest neighbours each
// vote with the normal of their plane, and the bin with most votes of a spherical accumulator wins. Principal
// components would average over both faces of an edge. The accumulator is a cube of 3 x 8 x 8 bins (11 degrees) for
// directions without sign. It is used in five fixed rotations, so that in one of them the mode is well inside a bin.
// The number of triplets follows Hoeffding's bound (700 by default, at most 2,048, and no triplet is drawn twice).
// Drawing stops when in one rotation the leading bin is significantly ahead of the next. The result is the
// area-weighted mean of the votes within 10 degrees, computed twice, starting at the centre of the leading bin. The
// curvature is that of the principal components (normals.h). There is no normal where principal components give none.
// Draws are keyed by the positions of the neighbours relative to the query, so the bits depend on nothing else. reach2
// is as in knn(). It takes about 2.5 microseconds per point.
void hough_normals(const NeighbourIndex& index, std::span<const std::uint32_t> queries,
                   const HoughNormalsParams& params, std::span<PackedNormal> out, std::span<std::int64_t> reach2);

}  // namespace ilot
