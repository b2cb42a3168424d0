// SPDX-License-Identifier: Apache-2.0
// The part of the ground that a run is asked for, in the coordinates of the clouds.
#pragma once
#include <array>
#include <vector>

namespace ilot {

// A closed ring; the last vertex is not repeated.
using Ring = std::vector<std::array<double, 2>>;

// Without polygons the area is the closed box. With polygons it is their union by the even-odd rule over all
// rings (holes are rings as well), and the box is that of their vertices.
struct Area {
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;
  std::vector<Ring> rings;

  // A point on an edge belongs to one of the two areas that share the edge. O(vertices), exact for points
  // farther from an edge than rounding of its interpolation.
  bool contains(double x, double y) const;
};

}  // namespace ilot
