// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/whole_street.h"

#include <utility>

#include "kernels/morphology/fill.h"
#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/outward_drops.h"
#include "kernels/morphology/region_links.h"
#include "tests/oracles/whole_fill.h"
#include "tests/oracles/whole_links.h"
namespace ilot::test {
namespace {

// Returns 1 for the labels that have a pixel on the border of the image.
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

// The rank of a zone as ground: whether it does not stand above its surroundings and is comparable in size with the
// largest zone, then its pixels.
using GroundRank = std::pair<bool, std::uint64_t>;
GroundRank ground_rank(std::uint64_t pixels, std::int32_t drops, std::uint64_t largest) {
  constexpr std::uint64_t kComparable = 10;
  return {drops <= 0 && pixels * kComparable >= largest, pixels};
}

// Returns the zone that is the ground, or 0 where there is none.
std::uint32_t ground_zone(const Image& filled, const PixelLabels& zones, Height flat) {
  const std::vector<std::uint32_t> sizes = zone_sizes(zones);
  const std::vector<std::int32_t> falls = outward_drops(filled, zones, flat);
  const std::uint32_t most = sizes[largest_zone(zones)];
  std::uint32_t best = 0;
  GroundRank rank;
  for (std::uint32_t z = 1; z < sizes.size(); ++z)
    if (const GroundRank r = ground_rank(sizes[z], falls[z], most); r > rank) rank = r, best = z;
  return best;
}

// Adds the pixels that a zone encloses: those from which no path from side to side leads to the border without crossing
// the zone.
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
  const std::uint32_t zone = ground_zone(ground.filled, zones, flat);
  ground.mask = zone == 0 ? std::vector<std::uint8_t>(range.size(), 0) : with_enclosed(zones, zone);
  for (std::size_t i = 0; i < ground.mask.size(); ++i)
    if (ground.filled.values[i] == kNoHeight) ground.mask[i] = 0;
  return ground;
}

}  // namespace ilot::test
