// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/tiled_ground.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "kernels/rasters/fill.h"
#include "kernels/rasters/fill_missing_tiled.h"
#include "kernels/rasters/flat_zones.h"
#include "kernels/rasters/flat_zones_tiled.h"
#include "kernels/rasters/link_regions_tiled.h"

namespace ilot {
namespace {

constexpr std::uint64_t kComparable = 10;  // a zone so many times smaller than the ground is none

Image as_image(const PixelLabels& labels) {
  Image image{labels.width, labels.height, std::vector<Height>(labels.of.size())};
  for (std::size_t i = 0; i < image.size(); ++i) image.values[i] = static_cast<Height>(labels.of[i]);
  return image;
}

WriteLabels label_writer(const StreetLayers& layers, const char* layer) {
  return [&layers, layer](std::size_t tile, const PixelLabels& labels) { layers.write(layer, tile, as_image(labels)); };
}

void fill_layer(const StreetLayers& layers, const char* from, const char* to) {
  fill_missing_tiled(layers.grid, around_reader_of(layers, from),
                     {writer_of(layers, "regions"), reader_of(layers, "regions")}, writer_of(layers, to));
}

// Groups of tiles that touch, numbered from 1; 0 for absent ones.
PixelLabels groups_of(const TileGrid& grid) {
  Image tiles = filled_image(grid.columns(), grid.rows(), kNoHeight);
  for (std::size_t t = 0; t < tiles.size(); ++t)
    if (grid.has(t)) tiles.values[t] = 0;
  return flat_zones(tiles, 0, Adjacency::eight);
}

struct LargestZones {
  std::vector<std::uint32_t> of_group;
  std::vector<std::uint64_t> taken, left_out;  // pixels; left out: at least kComparable of the one taken
};

// Zones of the layer "filled" into "zones"; the largest of each group of tiles.
LargestZones largest_zones(const StreetLayers& layers, const PixelLabels& groups, Height flat) {
  std::mutex mutex;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;  // zone, group
  const ZoneSizes sizes =
      flat_zones_tiled(layers.grid, flat, Adjacency::eight, reader_of(layers, "filled"),
                       [&](std::size_t tile, const PixelLabels& labels) {
                         std::vector<std::uint32_t> here;  // one a run of a row
                         std::unique_copy(labels.of.begin(), labels.of.end(), std::back_inserter(here));
                         std::sort(here.begin(), here.end());
                         here.erase(std::unique(here.begin(), here.end()), here.end());
                         layers.write("zones", tile, as_image(labels));
                         const std::lock_guard lock(mutex);
                         for (const std::uint32_t zone : here)
                           if (zone != 0) seen.emplace_back(zone, groups.of[tile]);
                       });
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  LargestZones found{std::vector<std::uint32_t>(groups.count + 1, 0), {}, {}};
  std::vector<std::uint32_t>& largest = found.of_group;
  for (const auto& [zone, group] : seen)
    if (largest[group] == 0 || sizes.pixels[zone] > sizes.pixels[largest[group]]) largest[group] = zone;
  for (const auto& [zone, group] : seen) {
    const std::uint64_t pixels = sizes.pixels[zone], most = sizes.pixels[largest[group]];
    if (zone == largest[group])
      found.taken.push_back(pixels);
    else if (pixels * kComparable >= most)
      found.left_out.push_back(pixels);
  }
  std::sort(found.left_out.rbegin(), found.left_out.rend());
  return found;
}

// What is not of the ground's zone, in parts that are joined from side to side, into "regions"; which of them are open.
std::vector<std::uint8_t> open_parts(const StreetLayers& layers, const PixelLabels& groups,
                                     const std::vector<std::uint32_t>& largest) {
  const TileGrid& grid = layers.grid;
  const auto outside = [&](std::size_t tile) {
    Image image = layer_tile(layers, "zones", tile);
    const std::uint32_t ground = largest[groups.of[tile]];
    for (Height& v : image.values) v = ground != 0 && static_cast<std::uint32_t>(v) == ground ? kNoHeight : 0;
    return image;
  };
  std::mutex mutex;
  std::vector<std::uint32_t> on_border;
  const ZoneSizes sizes =
      flat_zones_tiled(grid, 0, Adjacency::four, outside, [&](std::size_t tile, const PixelLabels& labels) {
        const TileFrame frame = tile_frame(grid, tile);
        std::vector<std::uint32_t> here;
        for (std::uint32_t y = 0; y < frame.height; ++y) {
          const bool end = y == 0 || y + 1 == frame.height;
          for (std::uint32_t x = 0; x < frame.width; x += end ? 1 : std::max(1u, frame.width - 1))
            if (grid.ends_at(frame.x + x, frame.y + y)) here.push_back(labels.of[std::size_t{y} * frame.width + x]);
        }
        layers.write("regions", tile, as_image(labels));
        const std::lock_guard lock(mutex);
        on_border.insert(on_border.end(), here.begin(), here.end());
      });
  std::vector<std::uint8_t> open(sizes.pixels.size(), 0);
  for (const std::uint32_t part : on_border) open[part] = 1;
  return open;
}

}  // namespace

GroundZones find_ground_tiled(const StreetLayers& layers, const RasterScale& scale, const GroundParams& params) {
  const Height flat = scale.units(params.flat);
  const ShortGapsParams gaps{scale.pixels(params.longest_gap), scale.units(params.gap_step)};
  for_each_tile(layers.grid,
                [&](std::size_t tile) {
                  const std::uint32_t halo = gaps.longest + 1;
                  layers.write("closed", tile,
                               without_halo(fill_short_gaps(layer_around(layers, "range", tile, halo), gaps), halo));
                },
                {40, gaps.longest + 1});
  fill_layer(layers, "closed", "linked");
  flat_zones_tiled(layers.grid, flat, Adjacency::eight, reader_of(layers, "linked"), label_writer(layers, "zones"));
  link_regions_tiled(layers.grid, {flat, scale.pixels(params.longest_link)}, reader_of(layers, "linked"),
                     around_reader_of(layers, "linked"), around_reader_of(layers, "zones"),
                     writer_of(layers, "closed"));
  fill_layer(layers, "closed", "filled");
  const PixelLabels groups = groups_of(layers.grid);
  const LargestZones zones = largest_zones(layers, groups, flat);
  const std::vector<std::uint32_t>& largest = zones.of_group;
  const std::vector<std::uint8_t> open = open_parts(layers, groups, largest);
  for_each_tile(layers.grid, [&](std::size_t tile) {
    Image mask = layer_tile(layers, "regions", tile);
    const bool any = largest[groups.of[tile]] != 0;
    const Image filled = layer_tile(layers, "filled", tile);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const auto part = static_cast<std::uint32_t>(mask.values[i]);
      mask.values[i] = any && filled.values[i] != kNoHeight && (part == 0 || open[part] == 0);
    }
    layers.write("mask", tile, mask);
  });
  for (const char* layer : {"closed", "linked", "regions", "zones"}) layers.drop(layer);
  const auto square_metres = [&](std::uint64_t pixels) {
    return static_cast<double>(pixels) * scale.pixel * scale.pixel;
  };
  GroundZones out;
  for (const std::uint64_t pixels : zones.taken) out.taken += square_metres(pixels);
  for (const std::uint64_t pixels : zones.left_out) out.left_out.push_back(square_metres(pixels));
  return out;
}

}  // namespace ilot
