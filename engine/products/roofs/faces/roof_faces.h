// SPDX-License-Identifier: Apache-2.0
// Merges labelled cells into faces.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/face_limits.h"
#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

struct RoofFaces {
  Partition faces;                      // regions are faces: connected cells on one plane
  std::vector<RoofPlane> planes;        // per face
  std::vector<std::uint32_t> of_point;  // per point of the site: 0 = none, else the face with its plane there
};

struct RoofFaceParams {
  double least_area = 0.25;  // m2
  FaceLimits limits;
};

// Cells of one plane that share an edge become a face. A face that is smaller than least_area or contains no point of
// its plane goes to the neighbour with which it shares the longest border, of those whose planes do not fall too low
// there; the smallest face goes first. A face without such a neighbour stays. Corners of the outline stay even where
// its edges are straight. cell_of_point: regions_of() the site's points.
RoofFaces roof_faces(const RoofSite& site, const RoofPlanes& planes, const Partition& cells,
                     std::span<const std::uint32_t> cell_of_point, std::vector<std::uint32_t> label,
                     const RoofFaceParams& params);

}  // namespace ilot
