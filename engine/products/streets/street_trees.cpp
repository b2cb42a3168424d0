// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_trees.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "engine/products/streets/street_labels.h"
#include "engine/products/streets/trees/crowns.h"
#include "engine/products/streets/trees/tree_shape.h"
#include "engine/products/streets/trees/trunks.h"
#include "engine/store/stretches.h"
#include "engine/tiles/lattice_cells.h"
#include "kernels/core/lists_by_key.h"

namespace ilot {
namespace {

// Choice: a treetop is told from the next in cells of about this size; a young tree is two of them wide.
constexpr double kLeastTreeCell = 0.3;  // metres
// Derived: half of the widest trunk and the ring around it, its lean over three metres of height, and stems beside each
// other (TrunkParams), so that a trunk at a border is the same for both tiles.
constexpr double kTrunkHalo = 3;  // metres around a tile
// Choice: above the roots and most of what lies around, below the crowns of most trees.
constexpr double kTrunkFrom = 0.3, kTrunkTo = 3.3;  // metres above the ground
// Choice: a trunk of 10 cm fills one; smaller ones break trunks with a step of points of 5 cm and more.
constexpr double kTrunkVoxel = 0.1;  // metres; a thin trunk fills one
// Choice: three of them are the least that is seen of a trunk; a point a slice is enough.
constexpr double kTrunkSlice = 0.25;              // metres
constexpr std::uint64_t kBytesOfRead = 2u << 20;  // points while they are read, with their labels
// Of a window in which crowns are found: five layers, the regions of two steps and what reading takes.
constexpr std::uint64_t kBytesOfCell = 30;
// More for a cell of a crown: its places in two orders and, where crowns are as small as the noise of their heights
// makes them (nine cells), its share of a region, of the passes to six others and of the joins.
constexpr std::uint64_t kBytesOfCrownCell = 70;
const char* const kLayers[] = {"tree top", "tree low", "tree above", "tree points", "tree bins"};

// The raster of tree cells: squares of 2^n pixels.
struct TreeRaster {
  std::uint32_t factor = 1;  // pixels along the side of a cell
  double cell = 0.4;         // metres
  TileLayers layers;
};

TreeRaster tree_raster(const StreetTiles& tiles) {
  TreeRaster out;
  const double pixel = tiles.raster().scale.pixel;
  out.layers = tiles.layers();
  TileGrid& grid = out.layers.grid;
  while (out.factor * pixel < kLeastTreeCell - 1e-9 && grid.side % (2 * out.factor) == 0) out.factor *= 2;
  out.cell = out.factor * pixel;
  grid.width /= out.factor, grid.height /= out.factor, grid.side /= out.factor;
  return out;
}

// A trunk in the coordinates of the whole raster.
struct PlacedTrunk {
  double x = 0, y = 0;  // tree cells
  Trunk trunk;
};

bool may_be_trunk(PointLabel label) {
  return label == PointLabel::vegetation || group_of(label) == PointLabel::other || label == PointLabel::none;
}

class TreeFinder {
 public:
  TreeFinder(const Store& store, const StreetTiles& tiles, StreetView view, const PassContext& context,
             const StreetTreesParams& params)
      : store_(store), tiles_(tiles), view_(view), context_(context), params_(params), raster_(tree_raster(tiles)) {
    trunks_.resize(tiles.raster().grid.count());
    trees_.resize(trunks_.size());
    crown_cells_.resize(trunks_.size());
    const double pixel = tiles.raster().scale.pixel;
    // Powers of two divide the side of a tile, so that all tiles have the same voxels.
    for (voxel_ = 1; 2 * voxel_ * pixel <= 1.5 * kTrunkVoxel;) voxel_ *= 2;
    halo_ = (static_cast<std::uint32_t>(std::ceil(kTrunkHalo / pixel)) + voxel_ - 1) / voxel_ * voxel_;
    slice_ = std::max(kTrunkSlice, 2 * pixel);
  }

  std::vector<StreetTree> find() {
    const std::uint64_t side = tiles_.raster().grid.side + 2 * halo_;
    const std::uint64_t columns = view_ == StreetView::air ? 0 : (side / voxel_ + 1) * (side / voxel_ + 1);
    const std::uint64_t voxels =
        columns * (4 + slices() * (sizeof(TrunkVoxel) + 2));  // at most, with marks, and pieces of those in use
    run_tasks(tiles_.raster().grid, std::vector<std::uint64_t>(trunks_.size(), voxels + side * side * 8 + kBytesOfRead),
              [&](std::size_t tile) { draw(tile); });
    std::vector<std::uint64_t> bytes;
    for (std::size_t tile = 0; tile < trunks_.size(); ++tile) bytes.push_back(bytes_of_window(tile));
    run_tasks(tiles_.raster().grid, bytes, [&](std::size_t tile) { find_in(tile); });
    for (const char* layer : kLayers) raster_.layers.drop(layer);
    std::vector<StreetTree> all;
    for (const std::vector<StreetTree>& of_tile : trees_) all.insert(all.end(), of_tile.begin(), of_tile.end());
    for (std::size_t i = 0; i < all.size(); ++i) all[i].id = static_cast<std::uint32_t>(i + 1);
    return all;
  }

 private:
  std::uint32_t slices() const {
    return static_cast<std::uint32_t>(std::ceil((kTrunkTo - kTrunkFrom) / slice_ - 1e-9));
  }
  Height least_height() const { return tiles_.raster().scale.units(params_.least_height); }
  std::uint32_t reach() const { return static_cast<std::uint32_t>(std::ceil(params_.reach / raster_.cell)); }

  // Reads the points of a tile and of a ring around it: the layers of the tile's cells, and its trunks.
  void draw(std::size_t tile) {
    const TileRaster& raster = tiles_.raster();
    const Image level = layer_around(tiles_.layers(), "level", tile, halo_);
    VegetationCells cells = empty_cells();
    TrunkVoxels voxels = empty_voxels(level.width);
    const Index3 corner = raster.corner(tile);
    const std::int64_t halo_units = halo_ * raster.pixel;
    const LatticeCells pixel_of(raster.pixel), voxel_of(raster.pixel * voxel_);
    const IndexBox box = raster.box(tile, halo_);
    for_each_stretch(store_, plan_view(store_, box, {}).slices, [&](const Stretch& s) {
      const std::vector<StreetLabel> labels = s.read(store_, columns::kStreet);
      for (std::size_t i = 0; i < s.codes.size(); ++i) {
        if (!may_be_trunk(labels[i].label)) continue;
        const Index3 p = s.position(i);
        if (!box.contains(p)) continue;
        const std::int64_t x = p.x - corner.x + halo_units, y = p.y - corner.y + halo_units;
        const std::uint32_t u = pixel_of(x), v = pixel_of(y);
        const Height ground = level.values[std::size_t{v} * level.width + u];
        if (ground == kNoHeight) continue;
        const Height z = height_of(p.z);
        add_to_voxels(x, y, z - ground, voxel_of, voxels);
        const bool own = u >= halo_ && v >= halo_ && u < halo_ + raster.grid.side && v < halo_ + raster.grid.side;
        if (own && labels[i].label == PointLabel::vegetation)
          add_to_cells((u - halo_) / raster_.factor, (v - halo_) / raster_.factor, z, z - ground, cells);
      }
    });
    crown_cells_[tile] =
        static_cast<std::uint64_t>(std::count_if(cells.above.values.begin(), cells.above.values.end(),
                                                 [least = least_height()](Height v) { return v >= least; }));
    write(tile, cells);
    place_trunks(tile, voxels);
  }

  VegetationCells empty_cells() const {
    const std::uint32_t side = raster_.layers.grid.side;
    const Image none = filled_image(side, side, kNoHeight), zero = filled_image(side, side, 0);
    return {none, none, none, zero, zero};
  }

  TrunkVoxels empty_voxels(std::uint32_t pixels) const {
    TrunkVoxels voxels;
    if (view_ == StreetView::air) return voxels;  // what is narrow and upright has few points or none
    voxels.width = voxels.height = (pixels + voxel_ - 1) / voxel_;
    voxels.slices = slices();
    voxels.side = voxel_ * tiles_.raster().scale.pixel;
    voxels.first = kTrunkFrom;
    voxels.slice = slice_;
    return voxels;
  }

  void add_to_voxels(std::int64_t x, std::int64_t y, Height above, const LatticeCells& voxel_of,
                     TrunkVoxels& voxels) const {
    const double h = above * tiles_.raster().scale.unit - kTrunkFrom;
    if (h < 0) return;
    const auto slice = static_cast<std::uint32_t>(std::min(h / slice_, 1e6));
    if (slice >= voxels.slices) return;
    const std::uint32_t a = voxel_of(x), b = voxel_of(y);
    const std::int64_t units = tiles_.raster().pixel * voxel_;
    TrunkVoxel& voxel = voxels.add(slice, a, b);
    voxel.x += static_cast<std::uint32_t>((x - a * units) * kTrunkSteps / units);
    voxel.y += static_cast<std::uint32_t>((y - b * units) * kTrunkSteps / units);
    ++voxel.points;
  }

  void add_to_cells(std::uint32_t x, std::uint32_t y, Height z, Height above, VegetationCells& cells) const {
    const std::size_t i = std::size_t{y} * cells.top.width + x;
    cells.top.values[i] = std::max(cells.top.values[i], z);
    cells.low.values[i] = cells.low.values[i] == kNoHeight ? z : std::min(cells.low.values[i], z);
    cells.above.values[i] = std::max(cells.above.values[i], above);
    ++cells.points.values[i];
    cells.bins.values[i] |= Height{1} << bin_of(above * tiles_.raster().scale.unit);
  }

  static std::uint32_t bin_of(double height) {
    return static_cast<std::uint32_t>(std::clamp(height / kVegetationBin, 0.0, kVegetationBins - 1.0));
  }

  void write(std::size_t tile, const VegetationCells& cells) const {
    const Image* const images[] = {&cells.top, &cells.low, &cells.above, &cells.points, &cells.bins};
    for (std::size_t i = 0; i < std::size(kLayers); ++i) raster_.layers.write(kLayers[i], tile, *images[i]);
  }

  // Keeps the trunks whose axis is in the tile.
  void place_trunks(std::size_t tile, const TrunkVoxels& voxels) {
    const double halo = halo_ * tiles_.raster().scale.pixel, side = raster_.layers.grid.side * raster_.cell;
    const TileFrame frame = tile_frame(raster_.layers.grid, tile);
    for (const Trunk& trunk : find_trunks(voxels)) {
      const double x = trunk.x - halo, y = trunk.y - halo;
      if (x >= 0 && y >= 0 && x < side && y < side)
        trunks_[tile].push_back({frame.x + x / raster_.cell, frame.y + y / raster_.cell, trunk});
    }
  }

  // Calls take(tile) for the tiles that the window around a tile overlaps.
  template <class Take>
  void for_tiles_around(std::size_t tile, const Take& take) const {
    const TileFrame frame = tile_frame(raster_.layers.grid, tile);
    const std::uint32_t side = raster_.layers.grid.side;
    const std::int64_t r = reach(), last = side - 1 + r;
    for (std::int64_t row = tile_index(frame.y - r, side); row <= tile_index(frame.y + last, side); ++row)
      for (std::int64_t column = tile_index(frame.x - r, side); column <= tile_index(frame.x + last, side); ++column)
        if (const std::size_t other = raster_.layers.grid.tile_at(row, column); other != kNoTile) take(other);
  }

  std::uint64_t bytes_of_window(std::size_t tile) const {
    const std::uint64_t wide = raster_.layers.grid.side + 2 * reach();
    std::uint64_t crowns = 0;
    for_tiles_around(tile, [&](std::size_t other) { crowns += crown_cells_[other]; });
    return wide * wide * kBytesOfCell + std::min(crowns, wide * wide) * kBytesOfCrownCell;
  }

  // A tile with the cells around it.
  struct Window {
    std::int64_t x = 0, y = 0;  // its first cell
    VegetationCells cells;
    std::vector<PlacedTrunk> trunks;
  };

  Window window_around(std::size_t tile) const {
    const TileFrame frame = tile_frame(raster_.layers.grid, tile);
    const auto r = std::int64_t{reach()};
    Window w{frame.x - r, frame.y - r, {}, {}};
    Image* const images[] = {&w.cells.top, &w.cells.low, &w.cells.above, &w.cells.points, &w.cells.bins};
    for (std::size_t i = 0; i < std::size(kLayers); ++i)
      *images[i] = layer_around(raster_.layers, kLayers[i], tile, reach());
    const std::int64_t x1 = w.x + w.cells.top.width, y1 = w.y + w.cells.top.height;
    for_tiles_around(tile, [&](std::size_t other) {
      for (const PlacedTrunk& t : trunks_[other])
        if (t.x >= w.x && t.y >= w.y && t.x < x1 && t.y < y1) w.trunks.push_back(t);
    });
    std::erase_if(w.trunks, [&](const PlacedTrunk& t) { return !carries_crown(w, t); });
    return w;
  }

  // Whether a trunk reaches up to vegetation that is high enough for a tree, over it or beside it.
  bool carries_crown(const Window& w, const PlacedTrunk& t) const {
    const auto cx = static_cast<std::int64_t>(t.x) - w.x, cy = static_cast<std::int64_t>(t.y) - w.y;
    const double unit = tiles_.raster().scale.unit;
    double low = INFINITY;
    for (std::int64_t y = std::max<std::int64_t>(0, cy - 1);
         y <= std::min<std::int64_t>(w.cells.top.height - 1, cy + 1); ++y)
      for (std::int64_t x = std::max<std::int64_t>(0, cx - 1);
           x <= std::min<std::int64_t>(w.cells.top.width - 1, cx + 1); ++x) {
        const auto i = static_cast<std::size_t>(y * w.cells.top.width + x);
        const Height above = w.cells.above.values[i];
        if (above == kNoHeight || above * unit < params_.least_height) continue;
        low = std::min(low, (w.cells.low.values[i] - w.cells.top.values[i] + above) * unit);
      }
    return t.trunk.to + slice_ >= std::min(low, kTrunkTo);
  }

  void find_in(std::size_t tile) {
    const Window w = window_around(tile);
    const Height least = least_height();
    if (std::none_of(w.cells.above.values.begin(), w.cells.above.values.end(), [&](Height v) { return v >= least; }))
      return;
    std::vector<TrunkCell> seeds;
    for (const PlacedTrunk& t : w.trunks)
      seeds.push_back({static_cast<std::uint32_t>(static_cast<std::int64_t>(t.x) - w.x),
                       static_cast<std::uint32_t>(static_cast<std::int64_t>(t.y) - w.y), t.trunk.radius});
    CrownParams params;
    params.least_height = least;
    params.cell = raster_.cell / tiles_.raster().scale.unit;
    const CrownRegions crowns = find_crowns(w.cells.above, seeds, params);
    const ListsByKey cells =
        lists_by_key(crowns.regions.size(), crowns.of.size(), [&](std::size_t i, const auto& take) {
          if (crowns.of[i] != 0) take(crowns.of[i] - 1);
        });
    for (std::size_t r = 0; r < crowns.regions.size(); ++r) add_tree(tile, w, crowns.regions[r], cells.of(r));
    std::sort(trees_[tile].begin(), trees_[tile].end(), [](const StreetTree& a, const StreetTree& b) {
      return std::tie(a.position.y, a.position.x) < std::tie(b.position.y, b.position.x);
    });
  }

  void add_tree(std::size_t tile, const Window& w, const CrownRegion& region, std::span<const std::uint32_t> crown) {
    const PlacedTrunk* trunk = region.trunk < 0 ? nullptr : &w.trunks[static_cast<std::size_t>(region.trunk)];
    const double tx = trunk ? trunk->x - static_cast<double>(w.x) : 0,
                 ty = trunk ? trunk->y - static_cast<double>(w.y) : 0;
    const double free = trunk ? std::max(1.0, 2 * trunk->trunk.radius / raster_.cell) : -1;
    const TreeShape shape = tree_shape(w.cells, crown, tx, ty, free);
    const double x = trunk ? tx : shape.x, y = trunk ? ty : shape.y;  // cells of the window
    const double radius = std::sqrt(static_cast<double>(shape.cells) / 3.14159265358979323846) * raster_.cell;
    if (radius < params_.least_radius || shape.points < params_.least_points) return;
    if (trunk == nullptr && shape.elongation > params_.longest_shape) return;
    const double px = (x + static_cast<double>(w.x)) * raster_.factor,
                 py = (y + static_cast<double>(w.y)) * raster_.factor;
    const TileFrame own = tile_frame(tiles_.raster().grid, tile);
    if (px < own.x || py < own.y || px >= own.x + own.width || py >= own.y + own.height) return;
    const Image ground =
        layer_window(tiles_.layers(), "level", static_cast<std::int64_t>(px), static_cast<std::int64_t>(py), 1, 1);
    if (ground.values[0] == kNoHeight) return;
    StreetTree tree;
    const TileRaster& raster = tiles_.raster();
    tree.position = {raster.crs_x(px), raster.crs_y(py), ground.values[0] * raster.unit};
    const double unit = raster.scale.unit;
    tree.height_m = (shape.top - ground.values[0]) * unit;
    tree.crown_base_m = std::max(0.0, (shape.base - ground.values[0]) * unit);
    tree.crown_radius_m = radius;
    tree.trunk_seen = trunk != nullptr;
    tree.trunk_radius_m = trunk ? trunk->trunk.radius : 0;
    tree.points = shape.points;
    tree.unseen_share = unseen_share(w.cells, crown, x, y, bin_of(tree.crown_base_m), bin_of(tree.height_m));
    if (tree.height_m < params_.least_height || radius < params_.least_shape * tree.height_m ||
        !is_wanted(tree.position))
      return;
    trees_[tile].push_back(tree);
  }

  bool is_wanted(Vec3 p) const {
    const double unit = store_.unit();
    return !context_.wanted || context_.wanted({std::llround(p.x / unit), std::llround(p.y / unit), 0});
  }

  const Store& store_;
  const StreetTiles& tiles_;
  StreetView view_;
  const PassContext& context_;
  const StreetTreesParams& params_;
  TreeRaster raster_;
  std::uint32_t halo_ = 0, voxel_ = 1;  // pixels
  double slice_ = kTrunkSlice;
  std::vector<std::vector<PlacedTrunk>> trunks_;  // by tile
  std::vector<std::vector<StreetTree>> trees_;    // by tile
  std::vector<std::uint64_t> crown_cells_;        // by tile
};

}  // namespace

std::vector<StreetTree> find_street_trees(const Store& store, const StreetTiles& tiles, StreetView view,
                                          const PassContext& context, const StreetTreesParams& params) {
  return TreeFinder(store, tiles, view, context, params).find();
}

}  // namespace ilot
