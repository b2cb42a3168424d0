// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/planes/join/join_pass.h"
#include "engine/products/product_labels.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

// The label of a point in the column "rows".
struct PlaneLabel {
  std::uint32_t plane = 0, shape = 0;  // final ids; 0 = none
  PackedNormal normal;
  std::uint8_t boundary = 0;  // 1 = a corner of the plane's outline
};

struct PlaneLabelParams {
  std::vector<std::uint32_t> final_id;          // per joined plane + 1: the id that is written, 0 = none; [0] = 0
  std::vector<JoinedPlane> planes;              // by final id - 1; residuals are measured to these planes
  bool write_normals = false;                   // the column "normals" goes into the clouds
  std::vector<std::uint32_t> final_shape = {};  // per joined shape + 1: the id that is written; empty = no shapes
};

// Labels from the columns "plane", "boundary" and, where they are written, "shape" and "normals".
ProductLabels plane_labels(PlaneLabelParams params);

}  // namespace ilot
