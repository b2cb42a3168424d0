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

// Computes the outline of a building of which only points are known, in whole millimetres from an anchor. It takes the
// alpha shape of the points in plan, regularises its boundary with a tolerance of 1.25 sampling steps and moves it out
// by at most half a step (kernels/outlines/regularise.h). The step is the square root of the shape's area per point.
// The result is valid polygons, the largest first, and none when the points enclose no area. If there are more than
// 2^18 points, only the first point of each square of 10 cm counts. The result is a function of the positions alone.
// O(n log n).
std::vector<SitePolygon> cluster_outline(std::span<const Point2> points, const ClusterOutlineParams& params = {});

}  // namespace ilot
