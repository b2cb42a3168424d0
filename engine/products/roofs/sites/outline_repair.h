// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

struct RepairedOutline {
  std::vector<SitePolygon> polygons;  // valid, the largest first; none when no part with an area is left
  std::string repair;                 // what was wrong and is repaired, or why no polygon is left; empty = no repair
};

// Returns polygons on the millimetre grid that are valid in the sense of ISO 19107: simple rings, holes inside,
// interior connected, outer rings counter-clockwise and holes clockwise. Consecutive vertices are 2 mm apart or more,
// because validators take nearer ones for one. A valid polygon keeps its other vertices. Other polygons are rebuilt by
// GEOS (MakeValid, then noded on the grid), and parts below `least_area` (m2) are left out. The vertices of the rings
// are whole millimetres from an anchor. The result depends on the vertices alone.
RepairedOutline repair_outline(const SitePolygon& rings, double least_area);

// The area in square metres without the holes.
double area_of(const SitePolygon& polygon);

// The area in square metres that two valid polygons with a common anchor share.
double shared_area(const SitePolygon& a, const SitePolygon& b);

}  // namespace ilot
