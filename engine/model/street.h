// SPDX-License-Identifier: Apache-2.0
// What the street product returns and deliverables take. Positions in the CRS, names that end in _m are metres.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/model/point_label.h"
#include "kernels/core/types.h"

namespace ilot {

// Something that stands on the ground.
struct StreetObject {
  std::uint32_t id = 0;  // from 1
  PointLabel label = PointLabel::other;
  double probability = 0;  // of that class
  Vec3 base;               // on the ground
  Vec3 middle;             // of its extent, on the ground
  double height_m = 0, length_m = 0, width_m = 0;
  double heading_deg = 0;  // of the length, from x towards y, 0 to below 180
  double area_m2 = 0;
  std::uint64_t points = 0;
  std::uint32_t stretch = 0, block = 0;  // the nearest; 0 = none
};

// A part of a line of facades: a block, or the gap between two.
struct FacadePart {
  std::uint32_t stretch = 0, number = 0;  // from 1; along the stretch
  Vec3 from, to;                          // on the ground
  double length_m = 0, height_m = 0;
};

struct StreetPlan {
  std::vector<StreetObject> objects;
  std::vector<FacadePart> blocks, gaps;
};

}  // namespace ilot
