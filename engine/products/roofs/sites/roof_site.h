// SPDX-License-Identifier: Apache-2.0
// A building before it has a model: where it stands and the points that were measured on it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/point2.h"

namespace ilot {

enum class GroundSource : std::uint8_t {
  measured,      // points of the ground around the outline
  lowest_point,  // none there: the lowest point near the outline
};

// One polygon of an outline. Vertices in whole millimetres from the site's anchor. The first ring is the outer one,
// counter-clockwise, the others are holes, clockwise; from the last vertex an edge leads to the first.
using SitePolygon = std::vector<std::vector<Point2>>;

struct RoofSite {
  std::string id;       // the footprint's, else made from the content; unique within a run
  Vec3 anchor;          // CRS units; where the coordinates below start. Whole millimetres of the CRS's own grid, so
                        // that neighbours that share a wall share its vertices
  SitePolygon outline;  // valid: simple rings, holes inside, at least 2 mm from vertex to vertex
  std::vector<Vec3> points;  // metres from the anchor: the building's points, in global order
  double ground = 0;         // metres above the anchor: where the walls end
  GroundSource ground_source = GroundSource::measured;
};

}  // namespace ilot
