// SPDX-License-Identifier: Apache-2.0
// How the surface of a wall differs from a plane. In the coordinates of a facade, x runs along it, z upwards, and `out`
// is the distance towards the street, all in metres.
#pragma once
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot::scan {

// The large form: a wall that leans and bows. Beyond its extent it continues as at its edge.
struct WallForm {
  double width = 1, height = 1;
  double lean = 0;        // `out` of the top, the foot is at 0
  double bow_across = 0;  // `out` of the middle upright, the ends are at 0
  double bow_up = 0;      // `out` of the middle height
  bool flat() const { return lean == 0 && bow_across == 0 && bow_up == 0; }
  double at(double x, double z) const;
  double most() const;  // the largest absolute value
};

// Returns the plane in least squares through the form over a rectangle: out = base + along * x + up * z.
struct FormPlane {
  double base = 0, along = 0, up = 0;
};
FormPlane plane_of_form(const WallForm& form, double x0, double x1, double z0, double z1);

// The fine relief: a rough surface, and stones in courses with joints between them.
struct WallRelief {
  double roughness = 0, grain = 0.05;          // half of the swing, and the size of its spots
  double stone_width = 0, stone_height = 0.3;  // stone_width 0 = no stones
  double joint = 0, joint_depth = 0;           // width of the joints, and their depth behind the stones
  double stone_out = 0;                        // stones stand out by up to this, more or less
  std::uint64_t key = 0;
  double most() const { return roughness + stone_out + joint_depth; }
};

// Returns `out` of the surface without the depth of joints.
double relief_at(const WallRelief& relief, double x, double z);

// Returns whether a position lies in a joint. Every second course begins with half a stone.
bool in_joint(const WallRelief& relief, double x, double z);

}  // namespace ilot::scan
