// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_tiles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/products/streets/ground/standing_features.h"
#include "engine/products/streets/ground/standing_form.h"
#include "engine/products/streets/ground/street_mask.h"
#include "engine/products/streets/objects/structures_beside.h"
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
constexpr std::uint64_t kBytesDrawn = 16;      // bytes per pixel of a tile that is drawn
constexpr std::uint64_t kBytesOfHeights = 16;  // the same with heights, counts and bins
constexpr std::uint64_t kBytesOfSums = 124;    // sums of the points of a cell, and its measures
// Choice: higher than cars and people, so that few of their points decide the form of a cell.
constexpr double kLeastOfShape = 1.5;  // metres above the terrain
// Choice: longer than the step between points on a wall, shorter than a person.
constexpr double kBinOfShape = 0.5;                  // metres
constexpr std::uint32_t kFirstBin = 2;               // from 1 m on
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
constexpr double kMaxDenseShare = 0.25;  // greatest share of points in dense cells for a view from the air
// Measured: 1 to 5 from the air, 14 where the ground alone was kept, 28 and more from the ground (docs/streets.md). A
// flight of more than 40 points a square metre of which the ground alone was kept may exceed it.
constexpr double kMostSpread = 20;  // 9th decile of points of a square metre divided by the 1st
// Choice: surveys of cities from aircraft have 1 to 100 points a square metre; scans from the ground are thinned to
// less than this only where they are also sparse on walls.
constexpr double kMostFlown = 200;  // points a square metre

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

// The level of each pixel of a tile. A pixel without one has the nearest within `reach` steps, and follows the terrain
// from there. `around` and `terrain` are the tile with reach + 1 pixels on all sides.
Image spread(const Image& around, const Image& terrain, std::uint32_t reach) {
  const std::uint32_t halo = reach + 1;
  return with_nearest_keys(around, reach, [&](const auto& nearest) {
    Image level = filled_image(around.width - 2 * halo, around.height - 2 * halo, kNoHeight);
    for (std::uint32_t y = 0; y < level.height; ++y)
      for (std::uint32_t x = 0; x < level.width; ++x) {
        const std::size_t i = std::size_t{y + halo} * around.width + x + halo;
        if (!nearest.any(i)) continue;
        const std::size_t from = nearest.pixel(i);
        const bool known = terrain.values[i] != kNoHeight && terrain.values[from] != kNoHeight;
        level.values[std::size_t{y} * level.width + x] =
            around.values[from] + (known ? terrain.values[i] - terrain.values[from] : 0);
      }
    return level;
  });
}

// What the pixels of a cell show that was scanned from the street.
struct CellPixels {
  HeightBins bins = 0;  // of all
  Height upright = 0, most_bins = 0, pixels = 0;
};

// `bins`: those of its pixels, row by row; `top`: the bin of its highest point.
CellPixels pixels_of(const HeightBins* bins, std::uint32_t factor, std::uint32_t top) {
  CellPixels out;
  for (std::uint32_t v = 0; v < factor; ++v)
    for (std::uint32_t u = 0; u < factor; ++u) {
      const HeightBins b = bins[v * kSide + u];
      out.bins |= b;
      out.pixels += b != 0;
      if (b >> kFirstBin == 0) continue;  // most pixels: nothing is upright there
      out.upright += is_upright(b, {kFirstBin, top});
      out.most_bins = std::max<Height>(out.most_bins, std::popcount(b >> kFirstBin));
    }
  return out;
}

// The form of a cell that was scanned from the street: what is upright in its pixels is a wall or a pole, whatever else
// is in the cell, and nothing else is.
StandingForm street_shape(StandingForm of_points, const CellPixels& pixels) {
  if (pixels.upright > 0) return StandingForm::upright;
  return of_points == StandingForm::upright || of_points == StandingForm::pole ? StandingForm::inclined : of_points;
}

// The layers of cells that say what stands there.
struct CellLayers {
  explicit CellLayers(std::uint32_t side) : shape(filled_image(side, side, 0)) { measures.fill(shape); }

  void set(CellMeasure m, std::size_t i, Height v) { measures[static_cast<std::size_t>(m)].values[i] = v; }
  void set_spread(std::size_t i, const StandingPoints::Spread& spread, double side) {
    std::uint32_t packed = 0;
    for (std::size_t k = 0; k < 3; ++k)
      packed |=
          static_cast<std::uint32_t>(std::min(1023LL, std::llround(spread.deviations[k] / side * kDeviationSteps)))
          << (10 * k);
    set(CellMeasure::deviations, i, static_cast<Height>(packed));
    set(CellMeasure::normal, i, static_cast<Height>(std::llround(1000 * spread.normal_z)));
  }
  void set_pixels(std::size_t i, const CellPixels& p) {
    set(CellMeasure::bins, i, static_cast<Height>(p.bins));
    set(CellMeasure::upright, i, p.upright);
    set(CellMeasure::most_bins, i, p.most_bins);
    set(CellMeasure::pixels, i, p.pixels);
  }

  Image shape;
  CellMeasures measures;
};

// The number of points of a cell that `tenths` tenths of all cells do not exceed.
std::uint32_t quantile_of(const std::map<std::uint32_t, std::uint64_t>& cells, std::uint64_t all,
                          std::uint32_t tenths) {
  std::uint64_t below = 0;
  for (const auto& [n, count] : cells) {
    below += count;
    if (10 * below >= all * tenths) return n;
  }
  return 0;
}

// The density from the number of cells (of `area` square metres each) by number of points.
PointDensity density_of(const std::map<std::uint32_t, std::uint64_t>& cells, double area) {
  std::uint64_t all = 0, points = 0, dense = 0;
  for (const auto& [n, count] : cells) all += count, points += n * count;
  if (points == 0) return {};
  const std::uint32_t median = quantile_of(cells, all, 5);
  for (const auto& [n, count] : cells)
    if (n > kDenseFactor * median) dense += n * count;
  return {median / area, static_cast<double>(dense) / static_cast<double>(points),
          static_cast<double>(quantile_of(cells, all, 9)) / quantile_of(cells, all, 1)};
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
    const std::int64_t row = windows[i].row, column = windows[i].column;
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
  const bool even = density.dense_share < kMaxDenseShare && density.spread <= kMostSpread;
  return even && density.median <= kMostFlown ? StreetView::air : StreetView::street;
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

StreetTiles::StreetTiles(const Store& store, const PassContext& context, double pixel_metres, double density,
                         SeeTile see)
    : store_(store),
      context_(context),
      tiles_(context, store.folder() / "streets", street_raster(store, context, pixel_metres), kUse),
      layers_(tiles_.layers()),
      cells_(cells_of(layers_, raster().scale, density)) {
  if (see)
    layers_.write = [this, see = std::move(see)](const char* layer, std::size_t tile, const Image& image) {
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
  Image lowest = filled_image(cells_.side(), cells_.side(), kAboveAll);
  std::uint64_t points = 0;
  for_points(tile, [&](std::size_t pixel, Height z) {
    range.values[pixel] = std::max(range.values[pixel], z);
    ++accumulation.values[pixel];
    Height& low = lowest.values[cells_.cell_of(pixel, kSide)];
    low = std::min(low, z);
    ++points;
  });
  for (Height& v : lowest.values) v = v == kAboveAll ? kNoHeight : v;
  layers().write("range", tile, range);
  layers().write("accumulation", tile, accumulation);
  cells_.layers.write("lowest", tile, lowest);
  context_.advance(points);
}

void StreetTiles::draw_heights(StreetView view) const {
  const Height clearance = raster().scale.units(kClearance), least = raster().scale.units(kLeastOfShape);
  const std::int64_t side = raster().pixel * cells_.factor;  // of a cell, in lattice units
  const auto bin = static_cast<Height>(std::max(1, raster().scale.units(kBinOfShape)));
  const std::uint64_t of_cells = kBytesOfSums * kSide * kSide / (std::uint64_t{cells_.factor} * cells_.factor);
  const std::vector<std::uint64_t> bytes(raster().grid.count(),
                                         kBytesOfHeights * kSide * kSide + of_cells + kBytesOfStretch);
  run_tasks(raster().grid, bytes, [&](std::size_t tile) {
    const Image terrain = layer_tile(cells_.layers, "terrain", tile);
    Image clear = filled_image(kSide, kSide, kNoHeight), clear_points = filled_image(kSide, kSide, 0);
    std::vector<StandingPoints> cells(terrain.size());
    std::vector<HeightBins> bins(clear.size(), 0);
    const Index3 corner = raster().corner(tile);
    const LatticeCells cell_of(side), pixel_of(raster().pixel);
    for_points_in(store_, raster().box(tile), [&](Index3 p) {
      const std::int64_t x = p.x - corner.x, y = p.y - corner.y;
      const std::uint32_t u = cell_of(x), v = cell_of(y);
      const std::size_t cell = std::size_t{v} * cells_.side() + u;
      if (terrain.values[cell] == kNoHeight) return;
      const Height z = height_of(p.z), above = z - terrain.values[cell];
      cells[cell].add(x - u * side, y - v * side, above, least);
      const std::size_t pixel = std::size_t{pixel_of(y)} * kSide + pixel_of(x);
      bins[pixel] |= HeightBins{1} << std::min<std::uint32_t>(kHeightBins - 1, std::max(0, above) / bin);
      if (above >= clearance) return;
      clear.values[pixel] = std::max(clear.values[pixel], z);
      ++clear_points.values[pixel];
    });
    CellLayers out(cells_.side());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t first = (i / cells_.side() * kSide + i % cells_.side()) * cells_.factor;
      const StandingPoints::Spread spread = cells[i].spread();
      StandingForm of = cells[i].shape(spread, static_cast<double>(side));
      if (view == StreetView::street) {
        const CellPixels pixels = pixels_of(bins.data() + first, cells_.factor,
                                            static_cast<std::uint32_t>(std::max(0, cells[i].top() / bin)));
        of = street_shape(of, pixels);
        out.set_spread(i, spread, static_cast<double>(side));
        out.set_pixels(i, pixels);
      }
      out.shape.values[i] = static_cast<Height>(of);
      out.set(CellMeasure::top, i, cells[i].top());
    }
    layers().write("clear", tile, clear);
    layers().write("clear points", tile, clear_points);
    cells_.layers.write("shape", tile, out.shape);
    for (std::size_t m = 0; m < (view == StreetView::street ? kCellMeasures : 1); ++m)
      cells_.layers.write(cell_measure_layer(static_cast<CellMeasure>(m)), tile, out.measures[m]);
  });
}

void StreetTiles::take_out_overhead() const {
  for_each_tile(raster().grid, [&](std::size_t tile) {
    const Image structure = layer_tile(cells_.layers, "structure", tile);
    const auto overhead = [](Height v) { return is_overhead(static_cast<Structure>(v)); };
    if (std::none_of(structure.values.begin(), structure.values.end(), overhead)) return;
    Image range = layer_tile(layers(), "range", tile), accumulation = layer_tile(layers(), "accumulation", tile);
    const Image clear = layer_tile(layers(), "clear", tile), points = layer_tile(layers(), "clear points", tile);
    for (std::size_t i = 0; i < range.size(); ++i)
      if (overhead(structure.values[cells_.cell_of(i, kSide)]))
        range.values[i] = clear.values[i], accumulation.values[i] = points.values[i];
    layers().write("range", tile, range);
    layers().write("accumulation", tile, accumulation);
  });
  for (const char* layer : {"clear", "clear points", "shape"}) layers().drop(layer);
  for (std::size_t m = 0; m < kCellMeasures; ++m)
    if (const auto measure = static_cast<CellMeasure>(m); measure != CellMeasure::top)
      layers().drop(cell_measure_layer(measure));
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
                  const Image terrain = terrain_of_pixels(cells_, tile, halo);
                  Image level = spread(layer_around(layers(), "bare", tile, halo), terrain, halo - 1);
                  const Image own = without_halo(terrain, halo);
                  Image mask = layer_tile(layers(), "mask", tile);
                  bool far = false;
                  for (std::size_t i = 0; i < level.size(); ++i) {
                    if (level.values[i] != kNoHeight) continue;
                    level.values[i] = own.values[i];
                    if (mask.values[i] == 0) mask.values[i] = 2, far = true;
                  }
                  layers().write("level", tile, level);
                  if (far) layers().write("mask", tile, mask);
                },
                {20, halo});
  layers().drop("bare");
}

void StreetTiles::count_above(double least_height, double low_height) const {
  const Height least = raster().scale.units(least_height), low_below = raster().scale.units(low_height),
               clearance = raster().scale.units(kClearance);
  const auto bin = static_cast<std::uint32_t>(std::max(1, raster().scale.units(raster().scale.bin())));
  for_each_tile(raster().grid, [&](std::size_t tile) {
    const Image level = layer_tile(layers(), "level", tile), structure = layer_tile(cells_.layers, "structure", tile);
    Image above = filled_image(kSide, kSide, 0), low = above, occupancy = above;
    for_points(tile, [&](std::size_t pixel, Height z) {
      const Height ground = level.values[pixel];
      if (ground == kNoHeight || z - ground < least) return;
      if (is_taken_out(static_cast<Structure>(structure.values[cells_.cell_of(pixel, kSide)]), z - ground, clearance))
        return;
      ++above.values[pixel];
      low.values[pixel] += z - ground < low_below;
      if (const std::uint32_t i = static_cast<std::uint32_t>(z - ground) / bin; i < kOccupancyBins)
        occupancy.values[pixel] |= 1 << i;
    });
    const Image of_cells = structures_beside(cells_, tile);
    Image beside = filled_image(kSide, kSide, 0);
    for (std::size_t i = 0; i < beside.size(); ++i) beside.values[i] = of_cells.values[cells_.cell_of(i, kSide)];
    layers().write("beside", tile, beside);
    layers().write("above", tile, above);
    layers().write("low", tile, low);
    layers().write("occupancy", tile, occupancy);
  });
}

}  // namespace ilot
