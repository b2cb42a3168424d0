// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/tiled_artefacts.h"

#include <atomic>

#include "kernels/rasters/box_minimum.h"
#include "kernels/rasters/flat_zones_tiled.h"
#include "kernels/rasters/reconstruct_tiled.h"

namespace ilot {
namespace {

// The ground and what stands on it around a tile, kNoHeight elsewhere.
Image inside_around(const StreetLayers& layers, std::size_t tile, std::uint32_t halo) {
  Image inside = layer_around(layers, "filled", tile, halo);
  const Image mask = layer_around(layers, "mask", tile, halo);
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (mask.values[i] != 1) inside.values[i] = kNoHeight;
  return inside;
}

bool touches(const Image& inside, std::size_t p) {
  const std::size_t w = inside.width;
  for (const std::size_t q : {p - w - 1, p - w, p - w + 1, p - 1, p + 1, p + w - 1, p + w, p + w + 1})
    if (inside.values[q] != kNoHeight) return true;
  return false;
}

// Upside down, with the ring at the local ground height; outside of it kNoHeight.
Image over_of(const StreetLayers& layers, std::size_t tile, std::uint32_t reach) {
  const std::uint32_t halo = reach + 1;
  const Image inside = inside_around(layers, tile, halo), around = box_minimum(inside, reach);
  Image over = without_halo(inside, halo);
  for (std::uint32_t y = 0; y < over.height; ++y) {
    for (std::uint32_t x = 0; x < over.width; ++x) {
      const std::size_t p = std::size_t{y + halo} * inside.width + x + halo;
      Height& v = over.values[std::size_t{y} * over.width + x];
      if (inside.values[p] != kNoHeight)
        v = -inside.values[p];
      else if (touches(inside, p))
        v = -around.values[p];
    }
  }
  return over;
}

// How much the filling raises each pixel of the ground; kNoHeight outside.
Image depth_of(const StreetLayers& layers, std::size_t tile) {
  Image depth = layer_tile(layers, "raised", tile);
  const Image over = layer_tile(layers, "over", tile), mask = layer_tile(layers, "mask", tile);
  for (std::size_t i = 0; i < depth.size(); ++i)
    depth.values[i] = mask.values[i] == 1 ? depth.values[i] - over.values[i] : kNoHeight;
  return depth;
}

// Lets water out over every pixel of large low plateaus, and fills again.
void drain(const StreetLayers& layers, Height least, Height most, std::uint32_t area) {
  const auto low = [&](std::size_t tile) {
    Image image = depth_of(layers, tile);
    for (Height& v : image.values) v = v >= least && v <= most ? 0 : kNoHeight;
    return image;
  };
  const ZoneSizes sizes =
      flat_zones_tiled(layers.grid, 0, Adjacency::four, low, [&](std::size_t tile, const PixelLabels& labels) {
        Image image{labels.width, labels.height, std::vector<Height>(labels.of.size())};
        for (std::size_t i = 0; i < image.size(); ++i) image.values[i] = static_cast<Height>(labels.of[i]);
        layers.write("regions", tile, image);
      });
  std::atomic<bool> any = false;
  for_each_tile(layers.grid, [&](std::size_t tile) {
    Image marker = layer_tile(layers, "raised", tile);
    const Image over = layer_tile(layers, "over", tile), plateaus = layer_tile(layers, "regions", tile);
    for (std::size_t i = 0; i < marker.size(); ++i) {
      const auto plateau = static_cast<std::uint32_t>(plateaus.values[i]);
      if (plateau == 0 || sizes.pixels[plateau] < area) continue;
      marker.values[i] = over.values[i];
      any = true;
    }
    layers.write("marker", tile, marker);
  });
  if (any)
    reconstruct_by_erosion_tiled(layers.grid, Adjacency::eight, reader_of(layers, "marker"), reader_of(layers, "over"),
                                 writer_of(layers, "raised"));
}

}  // namespace

void find_artefacts_tiled(const StreetLayers& layers, const RasterScale& scale, const ArtefactParams& params) {
  const Height least = scale.units(params.least_height);
  const std::uint32_t reach = scale.pixels(params.ring_reach);
  for_each_tile(layers.grid, [&](std::size_t tile) { layers.write("over", tile, over_of(layers, tile, reach)); },
                {24, reach + 1});
  fill_holes_tiled(layers.grid, Adjacency::eight, reader_of(layers, "over"), writer_of(layers, "raised"));
  drain(layers, least, scale.units(params.highest_kerb), scale.area(params.least_plateau));
  for_each_tile(layers.grid, [&](std::size_t tile) {
    Image height = depth_of(layers, tile);
    for (Height& v : height.values)
      if (v < least) v = kNoHeight;
    layers.write("height", tile, height);
  });
  for (const char* layer : {"over", "raised", "regions", "marker"}) layers.drop(layer);
}

}  // namespace ilot
