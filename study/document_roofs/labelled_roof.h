// SPDX-License-Identifier: Apache-2.0
// A roof as Boltcheva et al. 2019 takes it: points, each with the label of its face.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/delaunay/delaunay.h"

namespace ilot::bench {

// One building: its roof's points from the first of them, in metres, and their labels, 0 = none.
struct LabelledRoof {
  Vec3 anchor;
  std::vector<Vec3> points;
  std::vector<std::uint32_t> label;
  std::uint32_t labels = 0;  // they are 1 ... labels
  bool complex = false;      // more than a gable or a hip
};

// Whole millimetres in plan.
Point2 place_of(Vec3 p);

// Buildings of a scanned scene by their true faces (FILE.truth.json), in the order of ids; each polygon of the truth is
// a label, seen or not. Throws where the truth is missing.
std::vector<LabelledRoof> read_buildings(const std::string& file);

// The same building with our planes as labels: pieces of a plane that the mesh eroded at alpha (metres, in plan) holds
// together; pieces below `least` points and points without a plane are left out.
LabelledRoof relabelled(const LabelledRoof& truth, double alpha, std::uint32_t least);

}  // namespace ilot::bench
