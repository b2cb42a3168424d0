// SPDX-License-Identifier: Apache-2.0
// Pavements along kerbs: their widths, what is free of them, and their areas.
#pragma once
#include <span>
#include <vector>

#include "engine/model/street.h"
#include "engine/products/streets/pavements/pavement_width.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

struct StreetPavementsParams {
  double spacing = 1;  // metres of kerb for which one width is measured
  double around = 2;   // metres of kerb on both sides in which rows of objects are looked for
  // Choice: pavements have 0.8 to 5 m [RASt 06]; more level ground beside a road is a square, a yard or a garden.
  double reach = 6;         // metres
  double widest_road = 30;  // metres
};

// Measures the pavement at places along each kerb, on the images of the street. The places depend on the kerb alone, so
// neither threads nor tiles matter. Reads the layers "mask", "level", "accumulation", "above", "occupancy" and
// "candidates". `standing` is what pixels are, by number in the layer "candidates".
std::vector<PavementWidth> find_pavement_widths(const StreetTiles& tiles, std::span<const StreetKerb> kerbs,
                                                std::span<const PavementPixel> standing,
                                                const StreetPavementsParams& params = {});

}  // namespace ilot
