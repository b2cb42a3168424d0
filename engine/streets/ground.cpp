// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/ground.h"

#include "kernels/rasters/fill.h"
#include "kernels/rasters/flat_zones.h"
#include "kernels/rasters/link_regions.h"

namespace ilot {
namespace {

// Which labels have a pixel on the border of the image.
std::vector<std::uint8_t> on_border(const PixelLabels& labels) {
  std::vector<std::uint8_t> open(std::size_t{labels.count} + 1, 0);
  for (std::uint32_t y = 0; y < labels.height; ++y) {
    const bool end = y == 0 || y + 1 == labels.height;
    const std::uint32_t* row = labels.of.data() + std::size_t{y} * labels.width;
    for (std::uint32_t x = 0; x < labels.width; ++x)
      if (end || x == 0 || x + 1 == labels.width) open[row[x]] = 1;
  }
  return open;
}

// Adds what a zone encloses: all that no path from side to side leads from to the border without crossing it.
std::vector<std::uint8_t> with_enclosed(const PixelLabels& zones, std::uint32_t zone) {
  Image outside{zones.width, zones.height, std::vector<Height>(zones.of.size())};
  for (std::size_t i = 0; i < zones.of.size(); ++i) outside.values[i] = zones.of[i] == zone ? kNoHeight : 0;
  const PixelLabels parts = flat_zones(outside, 0, Adjacency::four);
  const auto open = on_border(parts);
  std::vector<std::uint8_t> mask(zones.of.size());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = parts.of[i] == 0 || open[parts.of[i]] == 0;
  return mask;
}

}  // namespace

Ground find_ground(const Image& range, const RasterScale& scale, const GroundParams& params) {
  const Height flat = scale.units(params.flat);
  const Image closed = fill_short_gaps(range, {scale.pixels(params.longest_gap), scale.units(params.gap_step)});
  const Image linked = link_regions(fill_missing(closed), {flat, scale.pixels(params.longest_link)});
  Ground ground{fill_missing(linked), {}};
  const PixelLabels zones = flat_zones(ground.filled, flat, Adjacency::eight);
  const std::uint32_t largest = largest_zone(zones);
  ground.mask = largest == 0 ? std::vector<std::uint8_t>(range.size(), 0) : with_enclosed(zones, largest);
  for (std::size_t i = 0; i < ground.mask.size(); ++i)
    if (ground.filled.values[i] == kNoHeight) ground.mask[i] = 0;
  return ground;
}

}  // namespace ilot
