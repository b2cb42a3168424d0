// SPDX-License-Identifier: Apache-2.0
// A building before it is modelled: its position and the points that were measured on it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/point2.h"

namespace ilot {

enum class GroundSource : std::uint8_t {
  measured,      // from points of the ground around the outline
  nearby,        // from points of the ground up to 50 m away, or the lowest point near the outline where it is lower
  lowest_point,  // there is no such point: the lowest point near the outline
  none,          // there is no point at all, and the height of the ground is not known
};

// One polygon of an outline. Vertices are in whole millimetres from the site's anchor. The first ring is the outer one,
// counter-clockwise; the others are holes, clockwise. An edge leads from the last vertex to the first.
using SitePolygon = std::vector<std::vector<Point2>>;

// A person says that the faces above two places are one. The plane of the first place stays where a plane through the
// points of both explains fewer of them.
struct FaceMerge {
  FlatPoint first, second;  // metres from the site's anchor
};

struct RoofSite {
  std::string id;  // id of the footprint, or else made from the content; unique within a run
  Vec3 anchor;  // CRS units; origin of the coordinates below. It is on the CRS's own grid of whole millimetres, so that
                // neighbours with a common wall share its vertices
  SitePolygon outline;       // valid: simple rings, holes inside, at least 2 mm from vertex to vertex
  std::vector<Vec3> points;  // metres from the anchor: the building's points in the outline, in global order
  std::vector<Vec3> beside;  // the same for points outside of the outline, within the margin; any roof may be theirs
  double ground = 0;         // metres above the anchor: where the walls end
  GroundSource ground_source = GroundSource::measured;
  std::vector<FaceMerge> merges = {};  // by hand, in their order
};

}  // namespace ilot
