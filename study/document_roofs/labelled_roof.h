// SPDX-License-Identifier: Apache-2.0
// A roof in the form that Boltcheva et al. 2019 use: points, each with the label of its face.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/delaunay/delaunay.h"

namespace ilot::bench {

// One building: the points of its roof relative to the first point, in metres, and their labels, 0 = none.
struct LabelledRoof {
  Vec3 anchor;
  std::vector<Vec3> points;
  std::vector<std::uint32_t> label;
  std::uint32_t labels = 0;  // labels are 1 ... labels
  bool complex = false;      // more complex than a gable or a hip
};

// Returns the position in plan in integer millimetres.
Point2 place_of(Vec3 p);

// Reads the buildings of a scanned scene by their true faces (FILE.truth.json), in the order of ids. Each polygon of
// the truth is a label, even if no point of it was seen. Throws where the truth is missing.
std::vector<LabelledRoof> read_buildings(const std::string& file);

// Returns the same building with our planes as labels. A label is a piece of a plane that is connected in the mesh
// eroded at alpha (metres, in plan). Pieces of fewer than `least` points and points without a plane are left out.
LabelledRoof relabelled(const LabelledRoof& truth, double alpha, std::uint32_t least);

}  // namespace ilot::bench
