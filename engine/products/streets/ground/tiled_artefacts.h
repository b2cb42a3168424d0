// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/artefacts.h"
#include "engine/tiles/street_layers.h"

namespace ilot {

// find_artefacts of a street that is too large to hold: from the layers "filled" and "mask" to "height" (above the
// ground around; kNoHeight where nothing stands), pixel by pixel what find_artefacts makes of the whole, and "bare":
// the ground below it, kNoHeight outside of the mask.
void find_artefacts_tiled(const StreetLayers& layers, const RasterScale& scale, const ArtefactParams& params = {});

}  // namespace ilot
