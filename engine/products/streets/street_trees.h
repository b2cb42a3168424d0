// SPDX-License-Identifier: Apache-2.0
// Trees as objects: where they stand, how high they are, and how wide their crowns.
#pragma once
#include <vector>

#include "engine/model/street.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

struct StreetTreesParams {
  // Choice: hedges and shrubs are lower.
  double least_height = 3;  // metres above the ground
  // Derived: the widest crowns of street trees, planes of 18 m, reach 10 m from the trunk, and their neighbours as far.
  double reach = 20;  // metres around a tile; crowns that reach farther are cut
  // Choice: the narrowest trees of cities, upright oaks and poplars, have crowns an eighth as wide as they are high.
  double least_shape = 0.0625;  // radius of the crown over the height
  // Choice: crowns are about round; what is longer without a trunk is a hedge or the edge of a roof.
  double longest_shape = 2.5;  // length over width
  // Choice: fewer points are twigs, or points of a wall that look like leaves.
  std::uint64_t least_points = 20;  // of a crown
  // Choice: narrower than the crown of a young tree (0.7 m in radius); what is smaller is a twig or noise.
  double least_radius = 0.35;  // metres, of the circle with the area of the crown
};

// Finds the trees of a street from the points with the label vegetation (column "street") and from what is narrow and
// upright below them (not from the air, where it has no points). Reads the layer "level". A tree belongs to the tile
// that contains its position, and is found from the points within `reach` of that tile, so neither threads nor blocks
// matter. Trees outside of the wanted area are left out. Numbered from 1, tile by tile, from south to north.
std::vector<StreetTree> find_street_trees(const Store& store, const StreetTiles& tiles, StreetView view,
                                          const PassContext& context, const StreetTreesParams& params = {});

}  // namespace ilot
