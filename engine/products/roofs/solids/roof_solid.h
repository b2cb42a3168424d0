// SPDX-License-Identifier: Apache-2.0
// The faces of a divided outline are raised to their planes and closed by walls and a floor.
#pragma once
#include <span>
#include <vector>

#include "engine/model/building.h"
#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

// Choice: below the noise of airborne heights; lower steps are drawn flat.
constexpr double kSameHeight = 0.01;  // metres

struct RoofSolid {
  std::vector<Vec3> vertices;  // metres from the site's anchor; x and y are whole millimetres, z whole tenths of one
  std::vector<BuildingSurface> surfaces;  // roof faces by region (plane_id = region), the floor, then the walls
  double floor = 0;                       // metres; it is below `ground` where a face comes near the ground
};

// Builds a closed solid over the faces. The faces are the regions from 1, connected by edges; each lies on the plane
// with its number - 1. Around a vertex of the partition, faces whose heights agree within same_height share one vertex
// of the solid, so a face deviates from its plane by less than that. Where heights do not agree, walls stand between
// the faces, each over one edge. An edge along which two faces swap their order in height gets a vertex at that place.
// Where high and low faces meet crosswise in a vertex, the solid would be pinched, so the lower faces are joined by a
// corner of 2 cm. O(edges log edges).
RoofSolid extrude_roof(Partition faces, std::span<const RoofPlane> planes, double ground,
                       double same_height = kSameHeight);

}  // namespace ilot
