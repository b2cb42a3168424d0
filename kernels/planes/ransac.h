// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_segments.h"

namespace ilot {

struct RansacParams {
  double epsilon = 0;             // units; greatest distance of an inlier
  double min_cos = 0;             // of the angle between an inlier's normal and the plane's
  std::int64_t connectivity = 1;  // units; a consensus set falls apart where points are farther apart
  std::uint32_t min_points = 3;   // fewest inliers of a plane, at least 3
  double probability = 0.99;      // that no larger plane was overlooked when one is taken
  std::uint64_t key = 0;          // of the random draws
  std::array<Vec3, 2> across{};   // directions that a plane's normal must stand across, if any:
  double max_across = 0;          // |normal . direction| at most this
};

using RansacPlanes = PlaneSegments;  // planes: least squares of their points

// Planes by random sample consensus, the largest first [A5, after Schnabel, Wahl and Klein 2007].
// A draw is a point and two more out of a window of its neighbours in the order of points (Morton order makes a window
// a place), kept when the three normals agree with the plane through them. Draws are scored many at a time, on at most
// 16,384 of the remaining points (every 2^i-th); counts stay exact as planes are taken out. The best is taken once the
// chance of having overlooked a larger one is below 1 - probability; it is refined [Lorraine thesis, 2.2.2]: least
// squares over its largest connected part, new consensus set by distance and angle around it, until the set no longer
// changes (at most 10 rounds; the plane kept is the one that the set was tested against, so that every labelled point
// lies within epsilon of it); the connected part that shares most points with the first is the plane's. A set of which
// more than half lies within epsilon of an earlier plane beside it, with normals that disagree with it, is a fringe of
// that plane (normals along an edge are mixtures): its points stay without a label. Points without a normal are never
// inliers. Draws depend on the key and the points alone. O(draws x points); draws adapt to the share of the smallest
// plane.
RansacPlanes ransac_planes(const OrientedPoints& points, const RansacParams& params);

}  // namespace ilot
