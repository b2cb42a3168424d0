// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/separation.h"

#include <algorithm>

#include "kernels/morphology/area_opening.h"
#include "kernels/morphology/h_maxima.h"
#include "kernels/morphology/watershed.h"
#include "kernels/rasters/gradient.h"

namespace ilot {

PixelLabels separate_artefacts(const Image& height, const RasterScale& scale, const SeparationParams& params) {
  const std::uint32_t area = std::max(1u, scale.area(params.least_area));
  const Image opened = area_opening(height, area, Adjacency::eight);
  const Image tops = h_maxima(opened, scale.units(params.rise), Adjacency::eight);
  return watershed(gradient(opened, Adjacency::eight), regional_maxima(tops, Adjacency::eight), Adjacency::eight);
}

}  // namespace ilot
