// SPDX-License-Identifier: Apache-2.0
// Dormers: fronts with windows that stand in the roof above a wall.
#pragma once
#include <vector>

#include "engine/model/facade.h"
#include "engine/products/facades/elements/regular_facade.h"
#include "engine/products/facades/openings/openings.h"
#include "engine/products/facades/walls/wall_outline.h"

namespace ilot {

struct DormerParams {
  OpeningParams openings;
  RegularParams regular;
  WallOutlineParams outline;
  bool regularise = true;
};

// A front in the roof: a site of its own (find_dormer_fronts), without its points, and the openings in it.
struct DormerFront {
  FacadeSite site;
  FacadeElement outline;
  std::vector<FoundRectangle> openings;  // none: no dormer
};
DormerFront find_dormer(const RaySamples& samples, const DormerParams& params = {});

// What stands in the roof is drawn where it stands: of each front with an
// opening its outline, kind `dormer`, as deep as it stands behind the facade's wall, and its openings, on its own plane
// and as deep as they go behind that. Openings of all fronts make rows and families together. The foot of a front is
// `occluded` where nothing was seen below it: the eaves hide it. Elements are appended with ids. Returns how many edges
// are not seen.
std::uint64_t add_dormers(const std::vector<DormerFront>& fronts, Facade& facade, const DormerParams& params = {});

}  // namespace ilot
