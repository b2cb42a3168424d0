// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/image.h"

namespace ilot {

struct SeparationParams {
  double least_area = 0.025;  // square metres of a top, and of an artefact
  double rise = 0.05;         // metres by which a top has to rise above the pass to a higher one
};

// One label for each thing that stands there, also where things touch [Hernandez and Marcotegui 2008, 5.1]: an opening
// by area takes away peaks smaller than least_area, what is left has one marker for each maximum that rises by more
// than `rise` (h-maxima), and a watershed of the gradient from the markers gives each pixel to one of them. Artefacts
// smaller than least_area are dropped. `height`: above the ground, kNoHeight where nothing stands. Labels by first
// pixel of their markers.
PixelLabels separate_artefacts(const Image& height, const RasterScale& scale, const SeparationParams& params = {});

}  // namespace ilot
