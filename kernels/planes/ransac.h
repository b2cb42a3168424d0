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
  std::int64_t connectivity = 1;  // units; a consensus set splits where points are farther apart
  std::uint32_t min_points = 3;   // fewest inliers of a plane, at least 3
  double probability = 0.99;      // that no larger plane was missed when one is taken
  std::uint64_t key = 0;          // of the random draws
  std::array<Vec3, 2> across{};   // directions to which the normal of a plane must be perpendicular, if any:
  double max_across = 0;          // |normal . direction| at most this
  double most_stretch = 1;        // upright planes connect over up to this times the connectivity, see below
};

using RansacPlanes = PlaneSegments;  // the planes are the least-squares planes of their points

// Finds planes by random sample consensus, the largest first [A5, after Schnabel, Wahl and Klein 2007].
// A draw is a point and two more from a window of its neighbours in the order of points (in Morton order a window is a
// place). It is kept when the three normals agree with the plane through the points. Draws are scored many at a time,
// on at most 16,384 of the remaining points (every 2^i-th). Counts stay exact when planes are removed. The best draw is
// taken once the chance that a larger plane was missed is below 1 - probability.
// It is refined [Lorraine thesis, 2.2.2]: least squares over its largest connected component, then a new consensus set
// by distance and angle around it, until the set no longer changes (at most 10 rounds). The plane kept is the one
// against which the set was tested, so every labelled point is within epsilon of it. The connected component that
// shares most points with the first one belongs to the plane.
// A set is a fringe of an earlier plane beside it when more than half of it is within epsilon of that plane and its
// normals disagree with that plane (normals along an edge are mixtures). The points of a fringe stay without a label.
// Beams from above meet a plane that leans by an angle at 1 / cos(angle) times the distance of their spots on the
// ground, so the connectivity of a plane is multiplied by 1 / |n.z|, by most_stretch at most (1 = never). Points
// without a normal are never inliers. Draws depend on the key and the points alone. O(draws x points). The number of
// draws adapts to the share of the smallest plane.
RansacPlanes ransac_planes(const OrientedPoints& points, const RansacParams& params);

}  // namespace ilot
