// SPDX-License-Identifier: Apache-2.0
// Dormers: fronts with windows in the roof above a wall.
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

// A front in the roof: its own site (DormerFronts) without its points, and the openings in it.
struct DormerFront {
  FacadeSite site;
  FacadeElement outline;
  std::vector<FoundRectangle> openings;  // without openings the front is no dormer
};
DormerFront find_dormer(const RaySamples& samples, const DormerParams& params = {});

// Draws the dormers where they stand. For each front with an opening, this adds its outline (kind `dormer`), as deep as
// it stands behind the wall of the facade. It also adds its openings on the plane of the front, as deep as they go
// behind it. The openings of all fronts form rows and families together. The foot of a front is `occluded` where
// nothing was seen below it, because the eaves hide it. Openings of which too little was seen are only possible ones,
// as on the wall. The elements are appended with ids. Returns the number of edges that are not seen, without those of
// possible openings.
std::uint64_t add_dormers(const std::vector<DormerFront>& fronts, Facade& facade, const DormerParams& params = {});

}  // namespace ilot
