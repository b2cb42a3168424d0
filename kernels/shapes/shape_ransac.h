// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/planes/plane_score.h"
#include "kernels/shapes/shape.h"

namespace ilot {

// The kinds that are searched for, as bits 1 << kind.
constexpr unsigned kAllShapes = 15;
constexpr unsigned shape_bit(ShapeKind kind) {
  return 1u << static_cast<unsigned>(kind);
}

struct ShapeRansacParams {
  double epsilon = 0;              // units; greatest distance of an inlier
  double min_cos = 0;              // of the angle between an inlier's normal and the shape's
  std::int64_t connectivity = 1;   // units; a consensus set splits where points are farther apart
  std::uint32_t min_points = 500;  // fewest inliers of a shape, at least 3
  double probability = 0.99;       // that no larger shape was missed when one is taken
  double max_radius = 0;           // units, of spheres and cylinders; 0 = the diagonal of the points' box
  unsigned kinds = kAllShapes;
  std::uint64_t key = 0;  // of the random draws
};

struct FoundShape {
  Shape shape;
  double rms = 0;  // root mean square distance of its points
  std::uint32_t points = 0;
};

struct ShapeSegments {
  std::vector<std::uint32_t> label;  // per point: 0 = none, else 1 + index into shapes
  std::vector<FoundShape> shapes;  // in the order in which they were taken, the largest first as far as draws can tell
};

// Finds planes, spheres, cylinders and cones by efficient RANSAC, the largest first [A6, Schnabel, Wahl and Klein
// 2007]. A draw is three points of one octree cell, of a level chosen evenly. Each kind makes a candidate from it where
// points and normals agree.
// Scoring is lazy. A candidate has a bound: the points of the octree leaves near it, or its count before other shapes
// were taken. It is counted only when no other could be better, so the chosen candidate is the one that a count of all
// would choose. It is taken once the chance that a larger shape was missed is below 1 - probability [Marchand 2018,
// I.3.1.5]. The best of each kind is refined by least squares [Lorraine thesis, 2.2.2] over its connected part, in at
// most 10 rounds. The largest result counts, but a simpler kind with 97% of its points is preferred (a plane is also a
// part of a huge sphere). The shape returned is the one against which its points were tested, so every labelled point
// is within epsilon of it.
// Connectivity is Euclidean and not a bitmap of the surface. So it is the same for all kinds, without seams and poles.
// A set is a fringe when two thirds of it are on earlier shapes beside it whose normals disagree (normals along an edge
// are mixtures, and look like a thin cylinder). A fringe stays without a label. Above 2^17 points, candidates are drawn
// from and counted on a share of the points, which is selected by the hash of their position. The result depends on the
// key and the set of points alone, except for points that coincide.
ShapeSegments ransac_shapes(const OrientedPoints& points, const ShapeRansacParams& params);

}  // namespace ilot
