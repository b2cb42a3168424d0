// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ilot {

struct RoofModelParams {
  double epsilon = 0;           // metres; greatest distance of a point from its face; 0 = from noise and density
  int min_points = 0;           // fewest points of a face; 0 = from the density
  double least_face_area = 0;   // m2; smaller faces go to a neighbour
  bool superstructures = true;  // false: only the main roof
};

}  // namespace ilot
