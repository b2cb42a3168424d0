// SPDX-License-Identifier: Apache-2.0
// Finds a side face among the points near an edge of a facade element.
#pragma once
#include <cstddef>
#include <vector>

namespace ilot {

struct FacePoint {
  double t, w, s;  // metres: across the side, out of the wall, along the side
};

// Where points of a side face may be, how deep the face must go, and how far along the side.
struct FaceSearch {
  double low, high, width;  // low, high: of t; width: of the cluster
  double deep, along;
};

// The points within [low, high] by t, and their narrowest cluster: [first, last).
struct FaceCluster {
  std::vector<FacePoint> points;
  std::size_t first = 0, last = 0;
};

struct FaceLine {
  double at = 0, rms = 0;   // t at the plane; root mean square distance of the points to the line
  std::size_t points = 0;   // 0: there is no face
  double error_factor = 0;  // `rms` times this is the standard deviation of `at`
};

// Takes, of all intervals of t with the width of the search, the one with most points (ties: the first). O(n log n).
FaceCluster densest_cluster(std::vector<FacePoint> points, const FaceSearch& search);

// Fits the line t = at + slope (w - depth) to the cluster by least squares. The cluster must be large enough, and go
// deep enough and far enough along the side.
FaceLine find_face(const FaceCluster& cluster, const FaceSearch& search, double depth);

// Handles a face with only one or two scan lines on it, or with an edge that split beams. There is no line in this
// case: the result is the mean of the cluster. The cluster must go far enough along the side and contain nearly all
// points there. The error of its points is taken to be at least `noise`.
FaceLine find_touches(const FaceCluster& cluster, const FaceSearch& search, double noise);

}  // namespace ilot
