// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/ground_surface.h"

#include <cmath>

#include "kernels/rasters/box_minimum.h"

namespace ilot {
namespace {

Image negative(Image image) {
  for (Height& v : image.values)
    if (v != kNoHeight) v = -v;
  return image;
}

Image opened(const Image& image, std::uint32_t reach) {
  return negative(box_minimum(negative(box_minimum(image, reach)), reach));
}

}  // namespace

Image ground_surface(const Image& lowest, const GroundSurfaceParams& params) {
  Image surface = lowest;
  std::uint32_t narrower = 0;
  for (const std::uint32_t reach : kGroundReaches) {
    const Image below = opened(surface, reach);
    const double wider = params.pixel_mm * (reach - narrower);
    const auto most = static_cast<Height>(std::lround(params.steepest * wider + params.roughness_mm));
    narrower = reach;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      Height& v = surface.values[i];
      if (v == kNoHeight || v - below.values[i] > most) v = below.values[i];
    }
  }
  return surface;
}

}  // namespace ilot
