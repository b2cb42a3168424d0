// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/image.h"

namespace ilot {

struct SeparationParams {
  double least_area = 0.025;  // square metres; least area of an artefact
  double least_top = 0.025;   // square metres; least area of a top
  double rise = 0.05;         // metres; a top rises by more than this above the pass to a higher one
};

// Gives one label to each object on the ground, also where objects touch [Hernandez and Marcotegui 2008, 5.1]. An area
// opening removes peaks smaller than least_top. Of the result, each maximum that rises by more than `rise` (h-maxima)
// is one marker. A watershed of the gradient from the markers gives each pixel to one of them. An artefact that has no
// pixel left after the opening, as a bollard in fine pixels, is one object. Artefacts smaller than least_area are
// dropped. `height` is above the ground, kNoHeight where nothing stands. The labels are ordered by the
// first pixel of their markers.
PixelLabels separate_artefacts(const Image& height, const RasterScale& scale, const SeparationParams& params = {});

}  // namespace ilot
