// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/separation.h"

#include <algorithm>
#include <vector>

#include "kernels/morphology/area_opening.h"
#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/h_maxima.h"
#include "kernels/morphology/watershed.h"
#include "kernels/rasters/gradient.h"

namespace ilot {
namespace {

// Gives artefacts that the opening has removed one height each, so that each is one maximum.
void keep_small(const Image& height, std::uint32_t least, Image& opened) {
  Image removed = opened;
  bool any = false;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const bool is_removed = opened.values[i] == kNoHeight && height.values[i] != kNoHeight;
    removed.values[i] = is_removed ? 0 : kNoHeight;
    any |= is_removed;
  }
  if (!any) return;
  const PixelLabels pieces = flat_zones(removed, 0, Adjacency::eight);
  const std::vector<std::uint32_t> sizes = zone_sizes(pieces);
  std::vector<Height> tops(sizes.size(), kNoHeight);
  for (std::size_t i = 0; i < removed.size(); ++i)
    if (pieces.of[i] != 0) tops[pieces.of[i]] = std::max(tops[pieces.of[i]], height.values[i]);
  for (std::size_t i = 0; i < removed.size(); ++i)
    if (pieces.of[i] != 0 && sizes[pieces.of[i]] >= least) opened.values[i] = tops[pieces.of[i]];
}

}  // namespace

PixelLabels separate_artefacts(const Image& height, const RasterScale& scale, const SeparationParams& params) {
  const std::uint32_t least = std::max(1u, scale.area(params.least_area)),
                      top = std::max(least, scale.area(params.least_top));
  Image opened = area_opening(height, top, Adjacency::eight);
  if (least < top) keep_small(height, least, opened);
  const Image tops = h_maxima(opened, scale.units(params.rise), Adjacency::eight);
  return watershed(gradient(opened, Adjacency::eight), regional_maxima(tops, Adjacency::eight), Adjacency::eight);
}

}  // namespace ilot
