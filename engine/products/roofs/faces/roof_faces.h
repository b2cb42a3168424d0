// SPDX-License-Identifier: Apache-2.0
// From labelled cells to faces.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

struct RoofFaces {
  Partition faces;                      // regions are faces: cells that touch and lie on one plane
  std::vector<RoofPlane> planes;        // per face
  std::vector<std::uint32_t> of_point;  // per point of the site: 0 = none, else the face that lies on its plane there
};

// Cells of one plane that share an edge become a face. A face that is smaller than least_area (m2) or holds none of its
// plane's points goes to the neighbour with which it shares the longest border, the smallest first. Corners of the
// outline stay even where its edges are straight.
// cell_of_point: regions_of() the site's points.
RoofFaces roof_faces(const RoofSite& site, const RoofPlanes& planes, const Partition& cells,
                     std::span<const std::uint32_t> cell_of_point, std::vector<std::uint32_t> label, double least_area);

}  // namespace ilot
