// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/tiles/raster_scale.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

struct CityBlocksParams {
  double pixel = 0.2;         // metres; pixel of the image in which lines are searched
  double window = 200;        // metres; lines are searched in windows of about this side
  double least_facade = 2.5;  // metres above the ground; lower pixels are no facade
  double half_width = 1;      // metres; pixels within this distance of a line belong to it
  double least_length = 20;   // metres; least length of facade in a stretch
  double smoothing = 1;       // metres before and after; window of the running median of the profile
  double depth = 5;           // metres; a street cuts at least this deep into the profile
  double least_gap = 3;       // metres; least width of a street
};

// A part of a stretch, as distances along it in metres.
struct StretchPart {
  double from = 0, to = 0;
  double height = 0;  // metres; of a block: median of its profile
};

// A straight line of facades, its blocks and the streets between them.
struct StreetStretch {
  double x = 0, y = 0;    // where it begins, in pixels of the whole image
  double dx = 1, dy = 0;  // direction of unit length, dx > 0 or dx = 0 < dy
  double length = 0;      // metres
  std::vector<StretchPart> blocks, gaps;
};

// Finds city blocks [Hernandez and Marcotegui 2008, 3.1]. Reads the layers "range", "accumulation", "mask" and "level".
// Facade pixels are not ground, reach least_facade above the ground and lie beside it. In windows on a fixed raster, a
// Hough transform weighted by accumulation finds lines. Lines of neighbouring windows that continue each other are one
// stretch; its line is the weighted least squares fit of all their pixels. The profile of heights along it is smoothed,
// and a watershed cuts it where a street opens. The stretches are ordered by their first pixels in the raster of
// windows.
std::vector<StreetStretch> find_city_blocks(const TileLayers& layers, const RasterScale& scale,
                                            const CityBlocksParams& params = {});

}  // namespace ilot
