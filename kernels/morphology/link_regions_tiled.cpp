// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/link_regions_tiled.h"

#include <algorithm>

#include "kernels/core/union_find.h"
#include "kernels/morphology/region_links.h"
#include "kernels/rasters/tiles.h"

namespace ilot {
namespace {

constexpr std::uint32_t kBytesPerPixel = 36;  // of a window: heights, zones twice, keys of 64 bits, waves

// Tells which pixels of a window are in present tiles: 1 or 0, run by run.
std::vector<std::uint8_t> inside_of(const TileGrid& grid, const LinkWindow& window, std::uint32_t width,
                                    std::uint32_t height) {
  std::vector<std::uint8_t> inside(std::size_t{width} * height, 0);
  const std::int64_t x1 = std::min<std::int64_t>(width, std::int64_t{grid.width} - window.x);
  const std::int64_t y1 = std::min<std::int64_t>(height, std::int64_t{grid.height} - window.y);
  for (std::int64_t y = std::max<std::int64_t>(0, -window.y); y < y1; ++y)
    for (std::int64_t x = std::max<std::int64_t>(0, -window.x), end = 0; x < x1; x = end) {
      end = std::min(x1, x + grid.side - (window.x + x) % grid.side);  // of the tile
      if (grid.contains(window.x + x, window.y + y))
        std::fill(inside.begin() + y * width + x, inside.begin() + y * width + end, std::uint8_t{1});
    }
  return inside;
}

// Whether no two tiles in reach of this one touch only at a corner. Then, when tiles are no smaller than links are
// long, one of the two ways around a corner stays in the image.
bool straight_around(const TileGrid& grid, std::size_t tile, std::uint32_t halo) {
  if (grid.tiles.empty()) return true;
  if (grid.side < halo) return false;
  const TilePlace place = grid.place(tile);
  const auto contains = [&](std::int64_t dx, std::int64_t dy) {
    return grid.tile_at(place.row + dy, place.column + dx) != kNoTile;
  };
  for (std::int64_t y = -1; y < 1; ++y)
    for (std::int64_t x = -1; x < 1; ++x) {
      if (contains(x, y) == contains(x + 1, y + 1) && contains(x + 1, y) == contains(x, y + 1) &&
          contains(x, y) != contains(x + 1, y))
        return false;
    }
  return true;
}

LinkWindow window_of(const TileGrid& grid, std::size_t tile, Image heights, const Image& zones, std::uint32_t halo) {
  const TileFrame frame = tile_frame(grid, tile);
  LinkWindow window;
  window.halo = halo;
  window.x = std::int64_t{frame.x} - halo;
  window.y = std::int64_t{frame.y} - halo;
  window.whole_width = grid.width;
  window.straight = straight_around(grid, tile, halo);
  window.inside = inside_of(grid, window, heights.width, heights.height);
  window.zones.resize(zones.size());
  std::transform(zones.values.begin(), zones.values.end(), window.zones.begin(),
                 [](Height zone) { return zone == kNoHeight ? 0u : static_cast<std::uint32_t>(zone); });
  window.heights = std::move(heights);
  return window;
}

// Returns the pixels of the drawn links, by tile.
std::vector<std::vector<LinkPixel>> drawn(const TileGrid& grid, std::vector<RegionLink> links) {
  std::sort(links.begin(), links.end(), [](const RegionLink& a, const RegionLink& b) { return a.order() < b.order(); });
  std::uint32_t zones = 0;
  for (const RegionLink& link : links) zones = std::max({zones, link.zone_a, link.zone_b});
  std::vector<std::uint32_t> parents(std::size_t{zones} + 1);
  UnionFind regions(parents);
  std::vector<std::vector<LinkPixel>> pixels(grid.count());
  for (const RegionLink& link : links) {
    if (!regions.unite(link.zone_a, link.zone_b)) continue;
    for (const LinkPixel& p : link.way) {
      const std::uint64_t x = p.pixel % grid.width, y = p.pixel / grid.width;
      pixels[grid.tile_with(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y))].push_back(p);
    }
  }
  return pixels;
}

}  // namespace

std::vector<std::vector<LinkPixel>> links_tiled(const TileGrid& grid, const LinkRegionsParams& params,
                                                const ReadAround& heights, const ReadAround& zones) {
  const std::uint32_t halo = link_halo(params);
  std::vector<std::vector<RegionLink>> found(grid.count());
  for_each_tile(grid,
                [&](std::size_t tile) {
                  const Image around = zones(tile, halo);
                  if (around.size() > 0)
                    found[tile] = links_in(window_of(grid, tile, heights(tile, halo), around, halo), params);
                },
                {kBytesPerPixel, halo});
  std::vector<RegionLink> links;
  for (auto& list : found) {
    std::move(list.begin(), list.end(), std::back_inserter(links));
    std::vector<RegionLink>().swap(list);
  }
  return drawn(grid, std::move(links));
}

}  // namespace ilot
