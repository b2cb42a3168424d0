// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

struct ClusterOutlineParams {
  double alpha = 700;          // millimetres: gaps narrower than twice this are closed
  double least_area = 4;       // m2; smaller parts are left out
  double least_courtyard = 4;  // m2; smaller holes are closed
};

// The outline of a building of which only points are known, from an anchor in whole millimetres: alpha shape of the
// points in plan, its boundary regularised with a tolerance of 1.25 sampling steps and moved out by half a step at most
// (kernels/outlines/regularise.h). The step is the root of the shape's area per point. Valid polygons, the largest
// first; none when the points enclose no area. Of more than 2^18 points the first of each square of 10 cm counts. A
// function of the positions alone. O(n log n).
std::vector<SitePolygon> cluster_outline(std::span<const Point2> points, const ClusterOutlineParams& params = {});

}  // namespace ilot
