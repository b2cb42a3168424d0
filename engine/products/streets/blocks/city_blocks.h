// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/tiles/raster_scale.h"
#include "engine/tiles/tile_layers.h"

namespace ilot {

struct CityBlocksParams {
  double pixel = 0.2;         // metres; of the image in which lines are sought
  double window = 200;        // metres; lines are sought in windows of about this side
  double least_facade = 2.5;  // metres above the ground; lower things are no facade
  double half_width = 1;      // metres; what lies so near to a line belongs to it
  double least_length = 20;   // metres of facade that a stretch has to have
  double smoothing = 1;       // metres before and after, of the running median of the profile
  double depth = 5;           // metres by which a street cuts into the profile
  double least_gap = 3;       // metres; a street is at least as wide
};

// From and to along a stretch, metres.
struct StretchPart {
  double from = 0, to = 0;
  double height = 0;  // metres; of a block: median of its profile
};

// A straight line of facades, its blocks and the streets between them.
struct StreetStretch {
  double x = 0, y = 0;    // where it begins, pixels of the whole
  double dx = 1, dy = 0;  // direction of unit length, dx > 0 or dx = 0 < dy
  double length = 0;      // metres
  std::vector<StretchPart> blocks, gaps;
};

// City blocks [Hernandez and Marcotegui 2008, 3.1] from the layers "range", "accumulation", "mask" and "level". Facade
// pixels are those that are not ground, reach least_facade above it and lie beside it. In windows on a fixed raster a
// Hough transform weighted by accumulation finds lines; those of neighbouring windows that go on in each other are one
// stretch, its line the weighted least squares of all their pixels. The profile of heights along it, smoothed, is cut
// by a watershed where a street opens. Stretches by their first pixels in the raster of windows.
std::vector<StreetStretch> find_city_blocks(const TileLayers& layers, const RasterScale& scale,
                                            const CityBlocksParams& params = {});

}  // namespace ilot
