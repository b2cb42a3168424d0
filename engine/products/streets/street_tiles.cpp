// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/products/streets/lattice_cells.h"
#include "engine/report/progress.h"
#include "engine/store/stretches.h"
#include "kernels/core/integers.h"
#include "kernels/geometry/box3.h"
#include "kernels/rasters/nearest.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

constexpr std::uint32_t kSide = 512;
// Tiles between two sites, at least: far more than any step looks beyond a tile (links of 10 m, lines of facades that
// go on in the next window of 200 m), whatever the pixel; at 5 cm 1.6 km.
constexpr std::int64_t kWidestGap = 64;
constexpr std::int64_t kMostPixels = (std::int64_t{1} << 31) - 1;  // in a direction
constexpr double kShareOfLayers = 0.15;                            // of the budget, for packed layers
constexpr std::uint64_t kBytesDrawn = 16;                          // per pixel of a tile that is drawn
constexpr std::uint64_t kBytesOfStretch = 1u << 20;                // of points as they are read, their chunks included
constexpr double kFinestPixel = 0.05;                              // metres
constexpr int kCoarsest = 20;                                      // times that
constexpr double kPointsOfPixel = 2.302585;  // at random: one pixel in ten is empty then, e to the power of minus this
constexpr double kPointsOfHalfStep = 0.25;   // a quarter of a pixel whose side is the step
constexpr std::uint32_t kCrowded = 4;        // times the median
constexpr double kMostCrowded = 1.0 / 3;     // of the points seen from the air

// Calls take(point) for the points of the store in a box.
template <class Take>
void for_points_in(const Store& store, const IndexBox& box, const Take& take) {
  for_each_stretch(store, plan_view(store, box, {}).slices, [&](const Stretch& s) {
    for (std::size_t i = 0; i < s.codes.size(); ++i)
      if (const Index3 p = s.position(i); box.contains(p)) take(p);
  });
}

std::uint64_t share_of(const PassContext& context, double share) {
  return static_cast<std::uint64_t>(share * static_cast<double>(context.budget_bytes));
}

std::int64_t whole_units(const Store& store, const PassContext& context, double metres) {
  return std::max<std::int64_t>(1, std::llround(metres / (store.unit() * context.metres_per_unit)));
}

// The level of each pixel of a tile that has none, from the nearest that has one within so many steps. `around`: the
// tile and one more pixel on all sides than that.
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

// Cells by their number of points, of so many square metres each.
PointDensity density_of(const std::map<std::uint32_t, std::uint64_t>& cells, double area) {
  std::uint64_t all = 0, below = 0, points = 0, crowded = 0;
  for (const auto& [n, count] : cells) all += count, points += n * count;
  std::uint32_t median = 0;
  for (const auto& [n, count] : cells) {
    below += count;
    if (median == 0 && 2 * below >= all) median = n;
    if (median != 0 && n > kCrowded * median) crowded += n * count;
  }
  return {median / area, points == 0 ? 0 : static_cast<double>(crowded) / static_cast<double>(points)};
}

}  // namespace

PointDensity point_density(const Store& store, const PassContext& context) {
  constexpr std::int64_t kCells = 64;
  const std::int64_t cell = whole_units(store, context, 1), side = cell * kCells;
  const LatticeCells cell_of(cell);
  const std::vector<PointWindow> windows = windows_with_points(store, context, side);
  std::map<std::uint32_t, std::uint64_t> all;  // cells by their number of points
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
  return density.crowded < kMostCrowded ? StreetView::air : StreetView::street;
}

double pixel_for(double density, StreetView view) {
  const double points = view == StreetView::air ? kPointsOfPixel : kPointsOfHalfStep;
  int times = 1;
  while (times < kCoarsest && density * kFinestPixel * kFinestPixel * times * times < points) ++times;
  return kFinestPixel * times;
}

double StreetRaster::crs(const FoldedAxis& axis, double at) const {
  const auto tile = static_cast<std::int64_t>(std::floor(at / grid.side));
  const std::int64_t origin = (axis.lattice(tile) - tile) * grid.side;
  return (static_cast<double>(origin) + at) * static_cast<double>(pixel) * unit;
}

std::int64_t StreetRaster::folded_pixel(const FoldedAxis& axis, std::int64_t lattice) const {
  const std::int64_t at = floor_divided(lattice, pixel), tile = floor_divided(at, grid.side);
  const std::int64_t folded = axis.folded(tile);
  return folded < 0 ? -1 : at + (folded - tile) * grid.side;
}

std::size_t StreetRaster::tile_over(Index3 p) const {
  return grid.tile_at(rows.folded(floor_divided(p.y, tile_units())), columns.folded(floor_divided(p.x, tile_units())));
}

PointWindow StreetRaster::window(std::size_t tile) const {
  const TilePlace place = grid.place(tile);
  return {rows.lattice(place.row), columns.lattice(place.column)};
}

Index3 StreetRaster::corner(std::size_t tile) const {
  const PointWindow at = window(tile);
  return {at.column * tile_units(), at.row * tile_units(), 0};
}

StreetTiles::StreetTiles(const Store& store, const PassContext& context, double pixel_metres)
    : store_(store),
      context_(context),
      packed_(store.folder() / "streets", share_of(context, kShareOfLayers)),
      runner_(context, packed_) {
  raster_.pixel = whole_units(store, context, pixel_metres);
  raster_.unit = store.unit();
  const double metres = store.unit() * context.metres_per_unit;
  raster_.scale = {metres, metres * static_cast<double>(raster_.pixel)};
  plan();
  raster_.grid.run = [this](std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body) {
    runner_.run(bytes, body);
  };
  raster_.grid.need = [this](std::uint64_t bytes) { runner_.need(bytes); };
  const std::vector<std::uint64_t> bytes(raster_.grid.count(), kBytesDrawn * kSide * kSide + kBytesOfStretch);
  run_tasks(raster_.grid, bytes, [&](std::size_t tile) { draw(tile); });
  layers_ = {raster_.grid,
             [this](const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) {
               packed_.read(layer, tile, part, out);
             },
             [this](const char* layer, std::size_t tile, const Image& image) { packed_.write(layer, tile, image); },
             [this](const char* layer) { packed_.drop(layer); }};
}

void StreetTiles::plan() {
  raster_.grid.side = kSide;
  const std::vector<PointWindow> windows = windows_with_points(store_, context_, raster_.tile_units());
  std::vector<std::int64_t> rows, columns;
  for (const auto& [row, column] : windows) rows.push_back(row), columns.push_back(column);
  std::sort(columns.begin(), columns.end());
  raster_.rows = FoldedAxis(rows, kWidestGap);
  raster_.columns = FoldedAxis(columns, kWidestGap);
  const std::int64_t width = raster_.columns.size() * kSide, height = raster_.rows.size() * kSide;
  if (std::max(width, height) > kMostPixels)
    throw Error(
        fmt::format("streets: the points are spread over {} tiles of {:.0f} m that do not touch, which is more "
                    "than a raster can hold: give a larger streets.pixel, or a part of them (--bounds)",
                    grouped(windows.size()), kSide * raster_.scale.pixel));
  raster_.grid.width = static_cast<std::uint32_t>(width);
  raster_.grid.height = static_cast<std::uint32_t>(height);
  for (const auto& [row, column] : windows)
    raster_.grid.tiles.push_back({static_cast<std::uint32_t>(raster_.rows.folded(row)),
                                  static_cast<std::uint32_t>(raster_.columns.folded(column))});
}

// take(pixel in the tile, z)
template <class Take>
void StreetTiles::for_points(std::size_t tile, const Take& take) const {
  const Index3 corner = raster_.corner(tile);
  const std::int64_t last = raster_.tile_units() - 1;
  const LatticeCells pixel_of(raster_.pixel);
  for_points_in(store_, column_over(corner.x, corner.y, corner.x + last, corner.y + last), [&](Index3 p) {
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
  packed_.write("range", tile, range);
  packed_.write("accumulation", tile, accumulation);
  context_.advance(points);
}

double StreetTiles::mean_accumulation() const {
  std::vector<std::uint64_t> points(raster_.grid.count(), 0), pixels(raster_.grid.count(), 0);
  for_each_tile(raster_.grid, [&](std::size_t tile) {
    const Image mask = layer_tile(layers_, "mask", tile), height = layer_tile(layers_, "height", tile),
                accumulation = layer_tile(layers_, "accumulation", tile);
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
  const std::uint32_t halo = raster_.scale.pixels(reach) + 1;
  for_each_tile(raster_.grid,
                [&](std::size_t tile) {
                  layers_.write("level", tile, spread(layer_around(layers_, "bare", tile, halo), halo - 1));
                },
                {16, halo});
  layers_.drop("bare");
}

void StreetTiles::count_above(double least_height, double low_height, StreetView view) const {
  const Height least = raster_.scale.units(least_height), low_below = raster_.scale.units(low_height);
  const auto bin = static_cast<std::uint32_t>(std::max(1, raster_.scale.units(raster_.scale.bin())));
  const std::uint32_t bins = view == StreetView::street ? kOccupancyBins : 0;
  for_each_tile(raster_.grid, [&](std::size_t tile) {
    const Image level = layer_tile(layers_, "level", tile);
    Image above = filled_image(kSide, kSide, 0), low = above, occupancy = above;
    for_points(tile, [&](std::size_t pixel, Height z) {
      const Height ground = level.values[pixel];
      if (ground == kNoHeight || z - ground < least) return;
      ++above.values[pixel];
      low.values[pixel] += z - ground < low_below;
      if (const std::uint32_t i = static_cast<std::uint32_t>(z - ground) / bin; i < bins)
        occupancy.values[pixel] |= 1 << i;
    });
    layers_.write("above", tile, above);
    layers_.write("low", tile, low);
    layers_.write("occupancy", tile, occupancy);
  });
}

}  // namespace ilot
