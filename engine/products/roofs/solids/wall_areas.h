// SPDX-License-Identifier: Apache-2.0
// How much of a building's walls stands against its neighbours.
#pragma once
#include <span>

#include "engine/model/building.h"
#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

// Choice: nobody passes through a gap of 0.2 m, and surveys of two neighbours differ by less.
constexpr double kSameWall = 0.2;  // metres between the outlines of two buildings with one wall between them

struct WallAreas {
  double party = 0, exterior = 0;  // m2
};

// `solid` is in the CRS. `neighbours` are the outlines of other buildings from the site's anchor. An outer wall is a
// party wall where the outline of a neighbour runs along it within kSameWall, from the floor up to the lower of its own
// top and the neighbour's roof. The height of that roof is the median of the points beside the wall (RoofSite::beside),
// metre by metre; no point there means no roof there. All other walls are exterior. O(walls x edges of neighbours +
// party walls x points beside).
WallAreas wall_areas(const Building& solid, const RoofSite& site, std::span<const SitePolygon> neighbours,
                     double metres_per_unit);

}  // namespace ilot
