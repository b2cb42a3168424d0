// SPDX-License-Identifier: Apache-2.0
// A side face among the points near an edge of something on a facade.
#pragma once
#include <cstddef>
#include <vector>

namespace ilot {

struct FacePoint {
  double t, w, s;  // metres: across the side, out of the wall, along the side
};

// Where points of a side face may lie, and how deep they should go and how far along.
struct FaceSearch {
  double low, high, width;  // of t; of the crowd
  double deep, along;
};

// The points within [low, high] by t, and the narrowest crowd of them: [first, last).
struct FaceCluster {
  std::vector<FacePoint> points;
  std::size_t first = 0, last = 0;
};

struct FaceLine {
  double at = 0, rms = 0;   // t at the plane; of the points to the line
  std::size_t points = 0;   // none: there is no face
  double error_factor = 0;  // times rms: standard deviation of `at`
};

// Of all stretches of t as wide as the search says, the one with most points (ties: the first). O(n log n).
FaceCluster densest_cluster(std::vector<FacePoint> points, const FaceSearch& search);

// The line t = at + slope (w - depth) through the crowd by least squares, where it is large, goes deep and along.
FaceLine find_face(const FaceCluster& cluster, const FaceSearch& search, double depth);

// Of a face that a scan line or two met, or that parted their beams: no line, but the mean of the crowd, where it goes
// along and nearly all that is there is in it. Its points are taken to be off by `noise` at least.
FaceLine find_touches(const FaceCluster& cluster, const FaceSearch& search, double noise);

}  // namespace ilot
