// SPDX-License-Identifier: Apache-2.0
#include "engine/run/street_tiles.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/pass/pass.h"
#include "engine/run/lattice_cells.h"
#include "engine/store/stretches.h"
#include "kernels/rasters/nearest.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

constexpr std::uint32_t kSide = 512;
constexpr std::int64_t kFar = std::int64_t{1} << 52;
constexpr double kShareOfLayers = 0.15;      // of the budget, for packed layers
constexpr double kShareOfTiles = 0.35;       // for the work on tiles; the rest: zones, borders, things, the allocator's
constexpr std::uint64_t kBytesDrawn = 16;    // per pixel of a tile that is drawn
constexpr double kFinestPixel = 0.05;        // metres
constexpr int kCoarsest = 20;                // times that
constexpr double kPointsOfPixel = 2.302585;  // at random: one pixel in ten is empty then, e to the power of minus this
constexpr double kPointsOfHalfStep = 0.25;   // a quarter of a pixel whose side is the step
constexpr std::uint32_t kCrowded = 4;        // times the median
constexpr double kMostCrowded = 1.0 / 3;     // of the points seen from the air

std::int64_t floor_divided(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// Calls take(point) for the points of the store in a box.
template <class Take>
void for_points_in(const Store& store, const IndexBox& box, const Take& take) {
  for_each_stretch(store, plan_view(store, box, {}).slices, [&](const Stretch& s) {
    for (std::size_t i = 0; i < s.codes.size(); ++i)
      if (const Index3 p = s.position(i); box.contains(p)) take(p);
  });
}

// Windows of a lattice of squares that may hold points: row, column.
std::vector<std::pair<std::int64_t, std::int64_t>> windows_of(const Store& store, std::int64_t side) {
  std::vector<std::pair<std::int64_t, std::int64_t>> windows;
  for (const Block& b : store.blocks())
    for (std::int64_t row = floor_divided(b.box.min.y, side); row <= floor_divided(b.box.max.y, side); ++row)
      for (std::int64_t column = floor_divided(b.box.min.x, side); column <= floor_divided(b.box.max.x, side); ++column)
        windows.emplace_back(row, column);
  std::sort(windows.begin(), windows.end());
  windows.erase(std::unique(windows.begin(), windows.end()), windows.end());
  return windows;
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
  const auto windows = windows_of(store, side);
  std::vector<std::map<std::uint32_t, std::uint64_t>> counts(windows.size());
  const std::vector<PassTask> tasks(windows.size(), {context.task_points * sizeof(std::uint64_t), 0});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const std::int64_t row = windows[i].first, column = windows[i].second;
    std::vector<std::uint32_t> cells(kCells * kCells, 0);
    for_points_in(
        store, {{column * side, row * side, -kFar}, {(column + 1) * side - 1, (row + 1) * side - 1, kFar}},
        [&](Index3 p) { ++cells[std::size_t{cell_of(p.y - row * side)} * kCells + cell_of(p.x - column * side)]; });
    for (const std::uint32_t n : cells)
      if (n > 0) ++counts[i][n];
  });
  std::map<std::uint32_t, std::uint64_t> all;
  for (const auto& some : counts)
    for (const auto& [n, cells] : some) all[n] += cells;
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

StreetTiles::StreetTiles(const Store& store, const PassContext& context, double pixel_metres)
    : store_(store), context_(context), packed_(store.folder() / "streets", share_of(context, kShareOfLayers)) {
  raster_.pixel = whole_units(store, context, pixel_metres);
  raster_.unit = store.unit();
  const double metres = store.unit() * context.metres_per_unit;
  raster_.scale = {metres, metres * static_cast<double>(raster_.pixel)};
  const std::int64_t side = raster_.pixel * kSide;
  const auto windows = windows_of(store, side);
  std::int64_t first = INT64_MAX, last = INT64_MIN;
  for (const auto& [row, column] : windows) first = std::min(first, column), last = std::max(last, column);
  const std::int64_t rows = windows.back().first - windows.front().first + 1;
  raster_.x = first * kSide;
  raster_.y = windows.front().first * kSide;
  raster_.grid = {
      static_cast<std::uint32_t>((last - first + 1) * kSide), static_cast<std::uint32_t>(rows * kSide), kSide, {}};
  std::vector<std::uint8_t> present(raster_.grid.count(), 0);
  std::vector<std::size_t> tiles;
  for (const auto& [row, column] : windows)
    tiles.push_back(static_cast<std::size_t>((row - windows.front().first) * raster_.grid.columns() + column - first));
  const auto run = [budget = share_of(context, kShareOfTiles)](std::span<const std::uint64_t> bytes,
                                                               const std::function<void(std::size_t)>& body) {
    std::vector<PassTask> tasks;
    for (const std::uint64_t b : bytes) tasks.push_back({b, b});
    run_pass(tasks, budget, body);
    malloc_trim(0);  // what lies freed between packed rows goes back to the system, which --memory counts
  };
  const std::uint64_t of_points = context.task_points * sizeof(std::uint64_t);  // of a block that is read
  const std::vector<std::uint64_t> bytes(tiles.size(), kBytesDrawn * kSide * kSide + of_points);
  run(bytes, [&](std::size_t i) { draw(tiles[i], present); });
  raster_.grid.present = std::move(present);
  raster_.grid.run = run;
  layers_ = {raster_.grid,
             [this](const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) {
               packed_.read(layer, tile, part, out);
             },
             [this](const char* layer, std::size_t tile, const Image& image) { packed_.write(layer, tile, image); },
             [this](const char* layer) { packed_.drop(layer); }};
}

// take(pixel in the tile, z)
template <class Take>
void StreetTiles::for_points(std::size_t tile, const Take& take) const {
  const TileFrame frame = tile_frame(raster_.grid, tile);
  const std::int64_t pixel = raster_.pixel, x0 = (raster_.x + frame.x) * pixel, y0 = (raster_.y + frame.y) * pixel;
  const IndexBox box{{x0, y0, -kFar}, {x0 + pixel * kSide - 1, y0 + pixel * kSide - 1, kFar}};
  const LatticeCells pixel_of(pixel);
  for_points_in(store_, box, [&](Index3 p) {
    take(std::size_t{pixel_of(p.y - y0)} * kSide + pixel_of(p.x - x0), static_cast<Height>(p.z));
  });
}

void StreetTiles::draw(std::size_t tile, std::vector<std::uint8_t>& present) {
  Image range = filled_image(kSide, kSide, kNoHeight), accumulation = filled_image(kSide, kSide, 0);
  std::uint64_t points = 0;
  for_points(tile, [&](std::size_t pixel, Height z) {
    range.values[pixel] = std::max(range.values[pixel], z);
    ++accumulation.values[pixel];
    ++points;
  });
  if (points == 0) return;
  present[tile] = 1;
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
