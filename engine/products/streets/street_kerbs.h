// SPDX-License-Identifier: Apache-2.0
// Kerbs as lines: steps of the ground between road and pavement.
#pragma once
#include <vector>

#include "engine/model/street.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

struct StreetKerbsParams {
  // Choice: as wide as a narrow gutter and the stone of a kerb; wider where the points are sparse.
  double least_radius = 0.4;  // metres, of the window in which a step is sought
  // Derived: twelve unknowns of two planes and an edge, three times over.
  double points_of_window = 40;
};

// Finds the kerbs of a street from the points with the label ground (column "street"): steps of 3 to 30 cm, at least
// two metres long. Places on steps are found tile by tile, each in the tile that contains it, from the points around
// it; then they are linked over all tiles. Neither threads nor blocks matter. Places outside of the wanted area are
// left out. Numbered from 1: seen lines first, then the gaps between them that something hides.
std::vector<StreetKerb> find_street_kerbs(const Store& store, const StreetTiles& tiles, const PointDensity& density,
                                          const PassContext& context, const StreetKerbsParams& params = {});

}  // namespace ilot
