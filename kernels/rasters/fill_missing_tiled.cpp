// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/fill_missing_tiled.h"

#include <mutex>

#include "kernels/rasters/flat_zones_tiled.h"
#include "kernels/rasters/tiles.h"

namespace ilot {
namespace {

Image absent_of(Image image) {
  for (Height& v : image.values) v = v == kNoHeight ? 0 : kNoHeight;
  return image;
}

Image as_image(const PixelLabels& labels) {
  Image image{labels.width, labels.height, std::vector<Height>(labels.of.size())};
  for (std::size_t i = 0; i < image.size(); ++i) image.values[i] = static_cast<Height>(labels.of[i]);
  return image;
}

// Lowers each region's level to what a tile knows of the heights around it.
void lower_levels(const TileGrid& grid, std::size_t tile, const Image& around, const Image& regions,
                  std::vector<Height>& levels, std::mutex& mutex) {
  const TileFrame frame = tile_frame(grid, tile);
  std::vector<std::pair<std::uint32_t, Height>> seen;
  const std::size_t stride = around.width;
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      const auto region = static_cast<std::uint32_t>(regions.values[std::size_t{y} * frame.width + x]);
      if (region == 0) continue;
      Height level = kAboveAll;
      const std::size_t p = (y + 1) * stride + x + 1;
      for (const std::size_t q :
           {p - stride - 1, p - stride, p - stride + 1, p - 1, p + 1, p + stride - 1, p + stride, p + stride + 1})
        if (around.values[q] != kNoHeight) level = std::min(level, around.values[q]);
      const bool edge = x == 0 || y == 0 || x + 1 == frame.width || y + 1 == frame.height;
      if (edge && grid.ends_at(frame.x + x, frame.y + y)) level = kNoHeight;
      if (level != kAboveAll) seen.emplace_back(region, level);
    }
  }
  const std::lock_guard lock(mutex);
  for (const auto& [region, level] : seen) levels[region] = std::min(levels[region], level);
}

}  // namespace

void fill_missing_tiled(const TileGrid& grid, const ReadAround& around, const RegionTiles& regions,
                        const WriteTile& write) {
  const ZoneSizes sizes = flat_zones_tiled(
      grid, 0, Adjacency::eight, [&](std::size_t tile) { return absent_of(around(tile, 0)); },
      [&](std::size_t tile, const PixelLabels& labels) { regions.write(tile, as_image(labels)); });
  std::vector<Height> levels(sizes.pixels.size(), kAboveAll);
  std::mutex mutex;
  for_each_tile(
      grid, [&](std::size_t tile) { lower_levels(grid, tile, around(tile, 1), regions.read(tile), levels, mutex); });
  for_each_tile(grid, [&](std::size_t tile) {
    Image image = around(tile, 0);
    const Image numbers = regions.read(tile);
    for (std::size_t i = 0; i < image.size(); ++i)
      if (numbers.values[i] != 0) image.values[i] = levels[static_cast<std::uint32_t>(numbers.values[i])];
    write(tile, image);
  });
}

}  // namespace ilot
