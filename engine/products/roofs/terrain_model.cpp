// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/terrain_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "engine/columns/ground_gaps.h"
#include "engine/columns/point_roles.h"
#include "engine/deliverables/layers/tile_sheets.h"
#include "engine/pass/pass.h"
#include "engine/store/stretches.h"
#include "engine/tiles/lattice_cells.h"
#include "engine/tiles/raster_layers.h"
#include "kernels/core/integers.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr RasterUse kUse{"terrain model", ""};
constexpr std::uint32_t kSide = 256;  // pixels, side of a tile
// Derived: the value for no data that readers of rasters expect.
constexpr float kNone = -9999;
// Choice: as far as the ground of a building is searched (roofs.md); halls up to 100 m wide are crossed.
constexpr double kReach = 50;  // metres
// Derived: the mean of four points has half the noise of one, and a raster of Poisson points with four a pixel leaves
// 2 % of the pixels empty.
constexpr double kPointsOfPixel = 4;
// Choice: sides that people use; the finest one with enough points is taken.
constexpr double kSides[] = {0.25, 0.5, 1, 2, 5};  // metres
// Choice: a cell of 16 m holds hundreds of points at the least density for roofs; the median of many is steady.
constexpr double kCell = 16;  // metres; side of the cells whose densities are compared
constexpr std::uint64_t kBytesPerPoint = 16, kBytesPerPixel = 48;

// The median number of points of the ground per square metre, over cells that have any; 0 without ground.
double ground_density(const Store& store, const PassContext& context) {
  const auto cell = static_cast<std::int64_t>(std::llround(kCell / (store.unit() * context.metres_per_unit)));
  std::map<PointWindow, std::uint64_t> counts;
  std::mutex adding;
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto roles = store.read(block, columns::kRole);
    const auto codes = store.read(block, columns::kCodes);
    std::map<PointWindow, std::uint64_t> own;
    for (std::size_t k = 0; k < roles.size(); ++k) {
      if (roles[k] != PointRole::ground) continue;
      const Index3 p = index_of({store.blocks()[block].node.tile, codes[k]});
      ++own[{floor_divided(p.y, cell), floor_divided(p.x, cell)}];
    }
    const std::lock_guard lock(adding);
    for (const auto& [window, count] : own) counts[window] += count;
  });
  if (counts.empty()) return 0;
  std::vector<std::uint64_t> all;
  for (const auto& [window, count] : counts) all.push_back(count);
  return static_cast<double>(lower_quantile(all, 0.5)) / (kCell * kCell);
}

double side_for(double density) {
  for (const double side : kSides)
    if (side * side * density >= kPointsOfPixel) return side;
  return kSides[std::size(kSides) - 1];
}

class TerrainRaster {
 public:
  TerrainRaster(const Store& store, const PassContext& context, double pixel_m)
      : store_(store),
        context_(context),
        units_(std::max<std::int64_t>(1, std::llround(pixel_m / (store.unit() * context.metres_per_unit)))),
        halo_(static_cast<std::uint32_t>(std::ceil(kReach / pixel_m))),
        tiles_(context, store.folder() / "terrain", plan_raster(store, context, units_, kSide, kUse), kUse),
        pixel_of_(units_) {}

  void write(const std::filesystem::path& folder, const Crs& crs) const {
    make_layers(0, [&](std::size_t tile) { measure(tile); });
    const std::uint32_t halo = halo_ + kSmoothings;
    make_layers(halo, [&](std::size_t tile) {
      const Image ground = layer_around(layers(), "ground", tile, halo);
      layers().write("terrain", tile, without_halo(smoothed_fill(ground, filled_ground(ground, halo_)), halo));
    });
    const TileSheets sheets(raster(), folder, crs);
    sheets.write({"dtm", RasterValue::real, kNone, [&](std::size_t tile) { return heights(tile); }});
    sheets.write({"dtm_points", RasterValue::whole, 0, [&](std::size_t tile) {
                    Image counts = layer_tile(layers(), "points", tile);
                    for (std::size_t i = 0; i < counts.size(); ++i)
                      if (!wanted(tile, i)) counts.values[i] = 0;
                    return std::vector<float>(counts.values.begin(), counts.values.end());
                  }});
  }

 private:
  const TileRaster& raster() const { return tiles_.raster(); }
  const TileLayers& layers() const { return tiles_.layers(); }

  template <class Make>
  void make_layers(std::uint32_t halo, const Make& make) const {
    const std::uint64_t side = kSide + 2 * std::uint64_t{halo};
    run_tasks(raster().grid, std::vector<std::uint64_t>(raster().grid.count(), side * side * kBytesPerPixel), make);
  }

  // Writes the layers "ground", mean heights in lattice units, and "points".
  void measure(std::size_t tile) const {
    std::vector<std::int64_t> sums(std::size_t{kSide} * kSide);
    Image counts = filled_image(kSide, kSide, 0), ground = filled_image(kSide, kSide, kNoHeight);
    const IndexBox box = raster().box(tile);
    for_each_stretch(store_, plan_view(store_, box, {}).slices, [&](const Stretch& s) {
      const auto roles = s.read(store_, columns::kRole);
      for (std::size_t i = 0; i < s.codes.size(); ++i) {
        const Index3 p = s.position(i);
        if (roles[i] != PointRole::ground || !box.contains(p)) continue;
        const std::size_t at = std::size_t{pixel_of_(p.y - box.min.y)} * kSide + pixel_of_(p.x - box.min.x);
        sums[at] += p.z;
        ++counts.values[at];
      }
    });
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (counts.values[i] > 0) ground.values[i] = static_cast<Height>(floor_divided(sums[i], counts.values[i]));
    layers().write("ground", tile, ground);
    layers().write("points", tile, counts);
  }

  std::vector<float> heights(std::size_t tile) const {
    const Image terrain = layer_tile(layers(), "terrain", tile);
    std::vector<float> out(terrain.size(), kNone);
    for (std::size_t i = 0; i < terrain.size(); ++i)
      if (terrain.values[i] != kNoHeight && wanted(tile, i))
        out[i] = static_cast<float>(terrain.values[i] * store_.unit());
    return out;
  }

  // Whether the middle of a pixel lies where products were asked for.
  bool wanted(std::size_t tile, std::size_t pixel) const {
    if (!context_.wanted) return true;
    const Index3 low = raster().corner(tile);
    const auto x = static_cast<std::int64_t>(pixel % kSide), y = static_cast<std::int64_t>(pixel / kSide);
    return context_.wanted({low.x + x * units_ + units_ / 2, low.y + y * units_ + units_ / 2, 0});
  }

  const Store& store_;
  const PassContext& context_;
  std::int64_t units_;  // lattice units of a pixel
  std::uint32_t halo_;  // pixels
  RasterLayers tiles_;
  LatticeCells pixel_of_;
};

}  // namespace

TerrainModel write_terrain_model(const Store& store, const std::filesystem::path& folder, const Crs& crs,
                                 const PassContext& context) {
  TerrainModel model;
  model.density_m2 = ground_density(store, context);
  if (!(model.density_m2 > 0)) return model;
  model.pixel_m = side_for(model.density_m2);
  TerrainRaster(store, context, model.pixel_m).write(folder, crs);
  return model;
}

}  // namespace ilot
