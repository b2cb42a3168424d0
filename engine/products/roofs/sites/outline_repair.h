// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

struct RepairedOutline {
  std::vector<SitePolygon> polygons;  // valid, the largest first; none when nothing with an area is left
  std::string repair;                 // what was wrong and has been mended, or why nothing is left; empty = nothing
};

// Polygons on the millimetre grid that are valid as ISO 19107 asks: simple rings, holes inside, interior connected,
// outer rings counter-clockwise and holes clockwise, vertices in a row 2 mm apart or more: validators take nearer ones
// for one. A valid polygon keeps its other vertices; others are rebuilt by GEOS (MakeValid, then noded on the grid),
// and parts below `least_area` (m2) are left out. The ring's vertices are whole millimetres from an anchor. Depends on
// the vertices alone.
RepairedOutline repair_outline(const SitePolygon& rings, double least_area);

// In square metres, holes taken out.
double area_of(const SitePolygon& polygon);

// Square metres that two valid polygons with a common anchor share.
double shared_area(const SitePolygon& a, const SitePolygon& b);

}  // namespace ilot
