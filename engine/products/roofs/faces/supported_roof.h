// SPDX-License-Identifier: Apache-2.0
// Which of the points beside an outline are on the roof inside of it. Eaves and imprecise outlines leave points of the
// roof outside; the roofs of neighbours lie there too. The planes decide, not the outlines of neighbours.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/roof_planes.h"
#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

struct SupportedRoof {
  RoofSite site;                      // its points are those of the outline, then those beside it on its planes
  RoofPlanes planes;                  // of this site
  std::vector<std::uint32_t> beside;  // the points beside the given site that were taken, ascending
};

// Finds the planes of the points in the outline and beside it. A plane stays if it has a point in the outline, and a
// point beside the outline stays if it is on such a plane.
SupportedRoof supported_roof(const RoofSite& site, const RoofModelParams& params);

// Returns values per point of the supported roof as values per point of the given site and per point beside it; 0 for
// points that were not taken.
std::vector<std::uint32_t> of_given_points(const RoofSite& given, const SupportedRoof& roof,
                                           std::span<const std::uint32_t> values);

}  // namespace ilot
