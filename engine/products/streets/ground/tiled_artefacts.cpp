// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/tiled_artefacts.h"

#include <algorithm>

#include "kernels/morphology/border_zones.h"
#include "kernels/morphology/reconstruct.h"
#include "kernels/morphology/tiled_filling.h"
#include "kernels/rasters/where.h"

namespace ilot {
namespace {

// The heights of the ground and of what stands on it, in and around a tile; kNoHeight elsewhere.
Image inside_around(const TileLayers& layers, std::size_t tile, std::uint32_t halo) {
  Image inside = layer_around(layers, "filled", tile, halo);
  const Image mask = layer_around(layers, "mask", tile, halo);
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (mask.values[i] != 1) inside.values[i] = kNoHeight;
  return inside;
}

// Returns whether p or one of its eight neighbours has a height. The function has no branches.
int touches(const Height* p, std::ptrdiff_t stride) {
  int any = 0;
  for (const Height* row : {p - stride, p, p + stride})
    any |= (*(row - 1) != kNoHeight) | (*row != kNoHeight) | (row[1] != kNoHeight);
  return any;
}

// The ground image upside down, with the ring at the local ground height; kNoHeight outside of the ring.
Image over_of(const TileLayers& layers, std::size_t tile) {
  const Image inside = inside_around(layers, tile, 1), foot = layer_tile(layers, "foot", tile);
  Image over = without_halo(inside, 1);
  for (Height& v : over.values) v = v == kNoHeight ? v : -v;
  for (std::uint32_t y = 0; y < over.height; ++y) {
    const Height* row = inside.values.data() + std::size_t{y + 1} * inside.width + 1;
    const Height* ground = foot.values.data() + std::size_t{y} * foot.width;
    Height* to = over.values.data() + std::size_t{y} * over.width;
    for_each_where(
        over.width,
        [&](std::size_t x) {
          return (row[x] == kNoHeight) & (ground[x] != kNoHeight) & touches(row + x, inside.width);
        },
        [&](std::size_t x) { to[x] = -ground[x]; });
  }
  return over;
}

// Stores the spills of tiles as a layer of three rows. The first column is their number.
SpillStore spills_in(const TileLayers& layers) {
  const auto write = [&layers](std::size_t tile, const std::vector<SpillEdge>& spills) {
    Image image = filled_image(static_cast<std::uint32_t>(spills.size()) + 1, 3, static_cast<Height>(spills.size()));
    for (std::size_t i = 0; i < spills.size(); ++i) {
      image.values[i + 1] = static_cast<Height>(spills[i].a);
      image.values[image.width + i + 1] = static_cast<Height>(spills[i].b);
      image.values[2 * std::size_t{image.width} + i + 1] = spills[i].height;
    }
    layers.write("spills", tile, image);
  };
  const auto read = [&layers](std::size_t tile) {
    Height count = 0;
    layers.read("spills", tile, {0, 0, 1, 1}, {&count, 1});
    const auto n = static_cast<std::uint32_t>(count);
    std::vector<Height> rows(3 * std::size_t{n});
    layers.read("spills", tile, {1, 0, n, 3}, {rows.data(), n});
    std::vector<SpillEdge> spills;
    for (std::size_t i = 0; i < n; ++i)
      spills.push_back({static_cast<std::uint32_t>(rows[i]), static_cast<std::uint32_t>(rows[n + i]), rows[2 * n + i]});
    return spills;
  };
  return {write, read};
}

// What the steps keep for a tile beside its layers.
struct TilePlateaus {
  std::vector<std::uint32_t> on_border;  // for each plateau its number on the tile's border; 0 = not on the border
  std::vector<std::uint32_t> pixels;     // for each plateau
};

// Fills the ground image that is upside down, and drains low plateaus.
class Draining {
 public:
  Draining(const TileLayers& layers, Height least, Height most, std::uint32_t area)
      : layers_(layers),
        least_(least),
        most_(most),
        area_(area),
        filling_(layers.grid, Adjacency::eight, spills_in(layers)),
        borders_(layers.grid),
        plateaus_(layers.grid.count()) {}

  void fill() {
    for_each_tile(layers_.grid,
                  [&](std::size_t tile) {
                    const Image over = over_of(layers_, tile);
                    layers_.write("over", tile, over);
                    layers_.write("raised", tile, filling_.fill(tile, over));
                  },
                  {30, 1});
    filling_.join();
    for_each_tile(layers_.grid, [&](std::size_t tile) {
      Image raised = layer_tile(layers_, "raised", tile);
      if (filling_.raise(tile, raised)) layers_.write("raised", tile, raised);
      const ZoneRuns plateaus =
          plateaus_of(raised, layer_tile(layers_, "over", tile), layer_tile(layers_, "mask", tile));
      plateaus_[tile] = {borders_.record(tile, plateaus), zone_pixels(plateaus)};
    });
    borders_.join(0, Adjacency::four);
  }

  // Lowers the filling to the ground on all pixels of large low plateaus, so that water runs off there.
  void drain() {
    const std::vector<std::uint64_t> joined = joined_sizes();
    for_each_tile(layers_.grid, [&](std::size_t tile) {
      const std::vector<std::uint8_t> large = large_ones(tile, joined);
      if (std::find(large.begin(), large.end(), 1) == large.end()) return;
      const Image over = layer_tile(layers_, "over", tile), raised = layer_tile(layers_, "raised", tile);
      const Image drained = reconstruct_by_erosion(marker_of(raised, over, layer_tile(layers_, "mask", tile), large),
                                                   over, Adjacency::eight);
      filling_.record_drained(tile, drained);
      layers_.write("raised", tile, drained);
    });
    filling_.join_drained();
  }

  // Writes two layers. "height": how much the filling raises each pixel of the ground; kNoHeight where that is little.
  // "bare": the ground without what stands on it; kNoHeight outside of the ground.
  void measure() {
    for_each_tile(layers_.grid, [&](std::size_t tile) {
      const Image over = layer_tile(layers_, "over", tile), mask = layer_tile(layers_, "mask", tile);
      Image height = layer_tile(layers_, "raised", tile), bare = layer_tile(layers_, "filled", tile);
      filling_.lower(tile, over, height);
      for (std::size_t i = 0; i < height.size(); ++i) {
        const Height depth = depth_at(height, over, mask, i);
        bare.values[i] = mask.values[i] == 1 ? bare.values[i] - (depth < least_ ? 0 : depth) : kNoHeight;
        height.values[i] = depth < least_ ? kNoHeight : depth;
      }
      layers_.write("height", tile, height);
      layers_.write("bare", tile, bare);
    });
  }

 private:
  // Returns kNoHeight outside of the ground.
  static Height depth_at(const Image& raised, const Image& over, const Image& mask, std::size_t i) {
    return mask.values[i] == 1 ? raised.values[i] - over.values[i] : kNoHeight;
  }

  // The regions in which the depth of the filling is that of a plateau.
  ZoneRuns plateaus_of(const Image& raised, const Image& over, const Image& mask) const {
    std::vector<std::uint8_t> low(raised.size());
    for (std::size_t i = 0; i < low.size(); ++i) {
      const Height depth = depth_at(raised, over, mask, i);
      low[i] = (depth >= least_) & (depth <= most_);
    }
    return flagged_runs(raised.width, raised.height, low, Adjacency::four);
  }

  static std::vector<std::uint32_t> zone_pixels(const ZoneRuns& zones) {
    std::vector<std::uint32_t> pixels(std::size_t{zones.count} + 1, 0);
    for_each_run(zones, [&](std::uint32_t zone, std::uint32_t, PixelRun run) { pixels[zone] += run.to - run.from; });
    return pixels;
  }

  std::vector<std::uint64_t> joined_sizes() const {
    std::vector<std::uint64_t> sizes(borders_.count(), 0);
    for (std::size_t t = 0; t < plateaus_.size(); ++t)
      for (std::size_t z = 1; z < plateaus_[t].pixels.size(); ++z)
        if (plateaus_[t].on_border[z] != 0)
          sizes[borders_.number(t, plateaus_[t].on_border[z])] += plateaus_[t].pixels[z];
    return sizes;
  }

  std::vector<std::uint8_t> large_ones(std::size_t tile, const std::vector<std::uint64_t>& joined) const {
    const TilePlateaus& plateaus = plateaus_[tile];
    std::vector<std::uint8_t> large(plateaus.pixels.size(), 0);
    for (std::size_t z = 1; z < large.size(); ++z) {
      const std::uint32_t on_border = plateaus.on_border[z];
      large[z] = (on_border == 0 ? plateaus.pixels[z] : joined[borders_.number(tile, on_border)]) >= area_;
    }
    return large;
  }

  // The marker for the next filling. It is the filling, lowered to the ground on plateaus that are `large`.
  Image marker_of(const Image& raised, const Image& over, const Image& mask,
                  const std::vector<std::uint8_t>& large) const {
    Image marker = raised;
    for_each_run(plateaus_of(raised, over, mask), [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
      if (large[zone] == 0) return;
      const auto row = static_cast<std::ptrdiff_t>(std::size_t{y} * marker.width);
      std::copy(over.values.begin() + row + run.from, over.values.begin() + row + run.to,
                marker.values.begin() + row + run.from);
    });
    return marker;
  }

  const TileLayers& layers_;
  Height least_, most_;
  std::uint32_t area_;
  TiledFilling filling_;
  BorderZones borders_;
  std::vector<TilePlateaus> plateaus_;
};

}  // namespace

void find_artefacts_tiled(const TileLayers& layers, const RasterScale& scale, const ArtefactParams& params) {
  Draining draining(layers, scale.units(params.least_height), scale.units(params.highest_kerb),
                    scale.area(params.least_plateau));
  draining.fill();
  draining.drain();
  draining.measure();
  for (const char* layer : {"over", "raised", "spills", "foot"}) layers.drop(layer);
}

}  // namespace ilot
