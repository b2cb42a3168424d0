// SPDX-License-Identifier: Apache-2.0
// Decides on which plane every cell of a divided outline lies.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/face_limits.h"
#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

struct CellLabelParams {
  double border = 0.15;  // m2 of contradicting points; cost of a metre of border between two faces
  double wall = 0.1;     // m2; cost of a square metre of wall between them, up to a height of half a metre
  FaceLimits limits;
  bool forbid_falls = false;  // a face may also not fall below its limits
};

// Returns a plane (1 + index) for every cell so that the sum of these costs is least:
//  - points that lie off their cell's plane: each with the area it stands for, and twice that from a metre on,
//  - borders between cells with different planes: by length and by the height of the wall along them,
//  - cells whose plane would be beyond its limits.
// The method is alpha-expansion [Boykov, Veksler, Zabih 2001] with integer capacities. Planes are expanded in the order
// of their numbers until nothing changes, for at most 8 rounds, so the result depends on the input alone. The border's
// cost is a metric over planes, so every expansion is one minimum cut (least_cut.h). A plane is a candidate only near
// its points, so the work grows with the size of the roof and not with its square. The result is empty where there are
// more than 2^18 cells and candidates together (16 MiB).
// cell_of_point: regions_of() the site's points.
std::vector<std::uint32_t> label_cells(const RoofSite& site, const RoofPlanes& planes, const Partition& cells,
                                       std::span<const std::uint32_t> cell_of_point,
                                       const CellLabelParams& params = {});

}  // namespace ilot
