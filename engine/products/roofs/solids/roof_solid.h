// SPDX-License-Identifier: Apache-2.0
// Faces of a parted outline raised to their planes and closed by walls and a floor.
#pragma once
#include <span>
#include <vector>

#include "engine/model/building.h"
#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

constexpr double kSameHeight = 0.01;  // metres

struct RoofSolid {
  std::vector<Vec3> vertices;  // metres from the site's anchor; x and y whole millimetres, z whole tenths of one
  std::vector<BuildingSurface> surfaces;  // roof faces by region (plane_id = region), the floor, then the walls
  double floor = 0;                       // metres; below `ground` where a face comes near it
};

// A closed solid over the faces (regions from 1, connected by edges, each on the plane with its number - 1). Around a
// vertex of the partition faces whose heights agree within same_height share one vertex of the solid, so a face is off
// its plane by less than that; where they do not, walls stand between them, each over one edge. Edges along which
// two faces change places get a vertex there. Where high and low faces meet crosswise in a vertex, which would pinch
// the solid, the lower ones are joined by a corner of 2 cm. O(edges log edges).
RoofSolid extrude_roof(Partition faces, std::span<const RoofPlane> planes, double ground,
                       double same_height = kSameHeight);

}  // namespace ilot
