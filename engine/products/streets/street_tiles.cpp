// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_tiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "engine/pass/pass.h"
#include "engine/store/stretches.h"
#include "engine/tiles/lattice_cells.h"
#include "kernels/core/integers.h"
#include "kernels/geometry/box3.h"
#include "kernels/rasters/nearest.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

constexpr std::uint32_t kSide = 512;
constexpr RasterUse kUse{"streets", "a larger streets.pixel, "};
constexpr std::uint64_t kBytesDrawn = 16;            // bytes per pixel of a tile that is drawn
constexpr std::uint64_t kBytesOfStretch = 1u << 20;  // memory of points while they are read, with their chunks
// Choice: at 5 cm a lamppost is two pixels wide; finer pixels cost time with the square.
constexpr double kFinestPixel = 0.05;  // metres
constexpr int kCoarsest = 20;          // times the finest pixel
// Derived: the comment on the line.
constexpr double kPointsOfPixel = 2.302585;  // at random, one pixel in ten is then empty: e to the power of minus this
// Derived: the comment on the line.
constexpr double kPointsOfHalfStep = 0.25;  // a quarter of a pixel whose side is the step
constexpr std::uint32_t kDenseFactor = 4;   // times the median
// Choice: docs/streets.md describes the rule; a flight over towers alone may exceed it.
constexpr double kMaxDenseShare = 1.0 / 3;  // greatest share of points in dense cells for a view from the air

// Calls take(point) for the points of the store in a box.
template <class Take>
void for_points_in(const Store& store, const IndexBox& box, const Take& take) {
  for_each_stretch(store, plan_view(store, box, {}).slices, [&](const Stretch& s) {
    for (std::size_t i = 0; i < s.codes.size(); ++i)
      if (const Index3 p = s.position(i); box.contains(p)) take(p);
  });
}

std::int64_t whole_units(const Store& store, const PassContext& context, double metres) {
  return std::max<std::int64_t>(1, std::llround(metres / (store.unit() * context.metres_per_unit)));
}

// The level of each pixel of a tile. A pixel without a level takes it from the nearest pixel with one within `reach`
// steps. `around` is the tile with reach + 1 pixels on all sides.
Image spread(const Image& around, std::uint32_t reach) {
  const std::uint32_t halo = reach + 1;
  return with_nearest_keys(around, reach, [&](const auto& nearest) {
    Image level = filled_image(around.width - 2 * halo, around.height - 2 * halo, kNoHeight);
    for (std::uint32_t y = 0; y < level.height; ++y)
      for (std::uint32_t x = 0; x < level.width; ++x) {
        const std::size_t i = std::size_t{y + halo} * around.width + x + halo;
        if (nearest.any(i)) level.values[std::size_t{y} * level.width + x] = around.values[nearest.pixel(i)];
      }
    return level;
  });
}

// The density from the number of cells (of `area` square metres each) by number of points.
PointDensity density_of(const std::map<std::uint32_t, std::uint64_t>& cells, double area) {
  std::uint64_t all = 0, below = 0, points = 0, dense_share = 0;
  for (const auto& [n, count] : cells) all += count, points += n * count;
  std::uint32_t median = 0;
  for (const auto& [n, count] : cells) {
    below += count;
    if (median == 0 && 2 * below >= all) median = n;
    if (median != 0 && n > kDenseFactor * median) dense_share += n * count;
  }
  return {median / area, points == 0 ? 0 : static_cast<double>(dense_share) / static_cast<double>(points)};
}

}  // namespace

PointDensity point_density(const Store& store, const PassContext& context) {
  constexpr std::int64_t kCells = 64;
  const std::int64_t cell = whole_units(store, context, 1), side = cell * kCells;
  const LatticeCells cell_of(cell);
  const std::vector<PointWindow> windows = windows_with_points(store, context, side);
  std::map<std::uint32_t, std::uint64_t> all;  // number of cells by their number of points
  std::mutex mutex;
  const std::vector<PassTask> tasks(windows.size(), {kBytesOfStretch, 0});
  run_pass(tasks, context.budget_bytes / 4, [&](std::size_t i) {
    const auto [row, column] = windows[i];
    std::vector<std::uint32_t> cells(kCells * kCells, 0);
    for_points_in(
        store, column_over(column * side, row * side, (column + 1) * side - 1, (row + 1) * side - 1),
        [&](Index3 p) { ++cells[std::size_t{cell_of(p.y - row * side)} * kCells + cell_of(p.x - column * side)]; });
    const std::lock_guard lock(mutex);
    for (const std::uint32_t n : cells)
      if (n > 0) ++all[n];
  });
  const double metres = static_cast<double>(cell) * store.unit() * context.metres_per_unit;
  return density_of(all, metres * metres);
}

StreetView view_of(const PointDensity& density) {
  return density.dense_share < kMaxDenseShare ? StreetView::air : StreetView::street;
}

double pixel_for(double density, StreetView view) {
  const double points = view == StreetView::air ? kPointsOfPixel : kPointsOfHalfStep;
  int times = 1;
  while (times < kCoarsest && density * kFinestPixel * kFinestPixel * times * times < points) ++times;
  return kFinestPixel * times;
}

TileRaster street_raster(const Store& store, const PassContext& context, double pixel_metres) {
  return plan_raster(store, context, whole_units(store, context, pixel_metres), kSide, kUse);
}

StreetTiles::StreetTiles(const Store& store, const PassContext& context, double pixel_metres, SeeTile see)
    : store_(store),
      context_(context),
      tiles_(context, store.folder() / "streets", street_raster(store, context, pixel_metres), kUse),
      layers_(tiles_.layers()) {
  if (see)
    layers_.write = [this, see](const char* layer, std::size_t tile, const Image& image) {
      see(raster(), layer, tile, image);
      tiles_.layers().write(layer, tile, image);
    };
  const std::vector<std::uint64_t> bytes(raster().grid.count(), kBytesDrawn * kSide * kSide + kBytesOfStretch);
  run_tasks(raster().grid, bytes, [&](std::size_t tile) { draw(tile); });
}

// Calls take(pixel in the tile, z) for each point of a tile.
template <class Take>
void StreetTiles::for_points(std::size_t tile, const Take& take) const {
  const Index3 corner = raster().corner(tile);
  const LatticeCells pixel_of(raster().pixel);
  for_points_in(store_, raster().box(tile), [&](Index3 p) {
    take(std::size_t{pixel_of(p.y - corner.y)} * kSide + pixel_of(p.x - corner.x), height_of(p.z));
  });
}

void StreetTiles::draw(std::size_t tile) {
  Image range = filled_image(kSide, kSide, kNoHeight), accumulation = filled_image(kSide, kSide, 0);
  std::uint64_t points = 0;
  for_points(tile, [&](std::size_t pixel, Height z) {
    range.values[pixel] = std::max(range.values[pixel], z);
    ++accumulation.values[pixel];
    ++points;
  });
  layers().write("range", tile, range);
  layers().write("accumulation", tile, accumulation);
  context_.advance(points);
}

double StreetTiles::mean_accumulation() const {
  std::vector<std::uint64_t> points(raster().grid.count(), 0), pixels(raster().grid.count(), 0);
  for_each_tile(raster().grid, [&](std::size_t tile) {
    const Image mask = layer_tile(layers(), "mask", tile), height = layer_tile(layers(), "height", tile),
                accumulation = layer_tile(layers(), "accumulation", tile);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (mask.values[i] != 1 || height.values[i] != kNoHeight || accumulation.values[i] == 0) continue;
      points[tile] += static_cast<std::uint64_t>(accumulation.values[i]);
      ++pixels[tile];
    }
  });
  std::uint64_t all_points = 0, all_pixels = 0;
  for (std::size_t t = 0; t < points.size(); ++t) all_points += points[t], all_pixels += pixels[t];
  return all_pixels == 0 ? 1 : static_cast<double>(all_points) / static_cast<double>(all_pixels);
}

void StreetTiles::spread_level(double reach) const {
  const std::uint32_t halo = raster().scale.pixels(reach) + 1;
  for_each_tile(raster().grid,
                [&](std::size_t tile) {
                  layers().write("level", tile, spread(layer_around(layers(), "bare", tile, halo), halo - 1));
                },
                {16, halo});
  layers().drop("bare");
}

void StreetTiles::count_above(double least_height, double low_height, StreetView view) const {
  const Height least = raster().scale.units(least_height), low_below = raster().scale.units(low_height);
  const auto bin = static_cast<std::uint32_t>(std::max(1, raster().scale.units(raster().scale.bin())));
  const std::uint32_t bins = view == StreetView::street ? kOccupancyBins : 0;
  for_each_tile(raster().grid, [&](std::size_t tile) {
    const Image level = layer_tile(layers(), "level", tile);
    Image above = filled_image(kSide, kSide, 0), low = above, occupancy = above;
    for_points(tile, [&](std::size_t pixel, Height z) {
      const Height ground = level.values[pixel];
      if (ground == kNoHeight || z - ground < least) return;
      ++above.values[pixel];
      low.values[pixel] += z - ground < low_below;
      if (const std::uint32_t i = static_cast<std::uint32_t>(z - ground) / bin; i < bins)
        occupancy.values[pixel] |= 1 << i;
    });
    layers().write("above", tile, above);
    layers().write("low", tile, low);
    layers().write("occupancy", tile, occupancy);
  });
}

}  // namespace ilot
