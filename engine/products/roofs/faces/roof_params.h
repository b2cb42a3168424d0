// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ilot {

struct RoofModelParams {
  double epsilon = 0;           // metres; greatest distance of a point from its face; 0 = from noise and density
  int min_points = 0;           // fewest points of a face; 0 = from the density
  double least_face_area = 0;   // m2; smaller faces go to a neighbour
  double detail = 0.15;         // metres; faces that differ by less are drawn as one; 0 = every plane is drawn
  bool superstructures = true;  // false: only the main roof
  double normal_angle = 25;     // degrees; greatest angle between a point's normal and that of its plane
  double same_angle = 3.5;      // degrees; planes that touch are joined up to this angle
  double least_epsilon = 0.08, most_epsilon = 0.3;     // metres; bounds of an epsilon from noise
  double main_roof_area = 12, main_roof_share = 0.15;  // m2, and share of the largest plane: see superstructures
  double border_cost = 0.3, wall_cost = 0.1;           // m2 for a metre of border, for a square metre of wall
  double overshoot = 0.5;                              // metres above its highest point that a face may rise
  double block_height = 0.7;                           // quantile of the heights of points: top of LoD1.2 and LoD1.3
  double lod13_step = 3;                               // metres between parts of LoD1.3; 0 = no LoD1.3
};

}  // namespace ilot
