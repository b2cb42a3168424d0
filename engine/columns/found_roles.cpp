// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/found_roles.h"

#include <cmath>
#include <map>

#include "engine/pass/pass.h"
#include "engine/store/stretches.h"
#include "engine/tiles/lattice_cells.h"
#include "engine/tiles/raster_layers.h"
#include "kernels/neighbours/normals.h"

namespace ilot {
namespace {

constexpr RasterUse kUse{"classes of points", ""};
constexpr std::uint32_t kSide = 128;  // side of a tile, in pixels
constexpr std::uint64_t kRoleBytesPerPoint = 32, kBytesOfTile = 8u << 20;

double unit_millimetres(const Store& store, const PassContext& context) {
  return store.unit() * context.metres_per_unit * 1000;
}

// The side of a pixel in lattice units: a power of two, about a metre.
std::int64_t pixel_units(double unit_mm) {
  int bits = 0;
  while (bits < kTileBits && std::ldexp(unit_mm, bits + 1) <= kRolePixelMetres * 1000) ++bits;
  return std::int64_t{1} << bits;
}

class RoleFinder {
 public:
  RoleFinder(const Store& store, const FoundRolesParams& params, const PassContext& context)
      : store_(store),
        params_(params),
        context_(context),
        unit_mm_(unit_millimetres(store, context)),
        tiles_(context, store.folder() / "ground", plan_raster(store, context, pixel_units(unit_mm_), kSide, kUse),
               kUse),
        pixel_of_(raster().pixel) {}

  RoleCounts find() {
    make_layer("lowest", [&](std::size_t tile) { return lowest(tile); });
    make_layer("ground", [&](std::size_t tile) { return ground(tile); });
    layers().drop("lowest");
    make_layer("buildings", [&](std::size_t tile) { return buildings(tile); });
    std::vector<PassTask> tasks;
    for (const Block& b : store_.blocks()) tasks.push_back({b.points * kRoleBytesPerPoint, b.points});
    std::vector<RoleCounts> counts(tasks.size());
    run_pass(tasks, context_.budget_bytes, [&](std::size_t i) { counts[i] = rewrite(static_cast<std::uint32_t>(i)); });
    return sum_of(counts);
  }

 private:
  const TileRaster& raster() const { return tiles_.raster(); }
  const TileLayers& layers() const { return tiles_.layers(); }
  Height height(std::int64_t z) const { return static_cast<Height>(std::lround(static_cast<double>(z) * unit_mm_)); }

  template <class Make>
  void make_layer(const char* layer, const Make& make) const {
    run_tasks(raster().grid, std::vector<std::uint64_t>(raster().grid.count(), kBytesOfTile),
              [&](std::size_t tile) { layers().write(layer, tile, make(tile)); });
  }

  // The pixel of a point in the image of a tile with a halo of so many pixels.
  std::size_t pixel_in(std::size_t tile, std::uint32_t halo, Index3 p) const {
    const Index3 low = raster().box(tile, halo).min;
    return std::size_t{pixel_of_(p.y - low.y)} * (kSide + 2 * halo) + pixel_of_(p.x - low.x);
  }

  // Calls take(stretch, index, position) for the points of a tile with a halo of so many pixels. Calls `begin` with
  // each stretch before its points.
  template <class Begin, class Take>
  void for_points(std::size_t tile, std::uint32_t halo, const Begin& begin, const Take& take) const {
    const IndexBox box = raster().box(tile, halo);
    for_each_stretch(store_, plan_view(store_, box, {}).slices, [&](const Stretch& s) {
      begin(s);
      for (std::size_t i = 0; i < s.codes.size(); ++i)
        if (const Index3 p = s.position(i); box.contains(p)) take(i, p);
    });
  }

  Image lowest(std::size_t tile) const {
    Image image = filled_image(kSide, kSide, kNoHeight);
    for_points(
        tile, 0, [](const Stretch&) {},
        [&](std::size_t, Index3 p) {
          Height& v = image.values[pixel_in(tile, 0, p)];
          const Height z = height(p.z);
          if (v == kNoHeight || z < v) v = z;
        });
    return image;
  }

  Image ground(std::size_t tile) const {
    GroundSurfaceParams params;
    params.pixel_mm = static_cast<double>(raster().pixel) * unit_mm_;
    return without_halo(ground_surface(layer_around(layers(), "lowest", tile, kGroundHalo), params), kGroundHalo);
  }

  // An image with 1 on the pixels of buildings.
  Image buildings(std::size_t tile) const {
    constexpr std::uint32_t kAround = kSide + 2 * kMaskHalo;
    const Image ground = layer_around(layers(), "ground", tile, kMaskHalo);
    std::vector<HighPoints> pixels(std::size_t{kAround} * kAround);
    std::vector<PackedNormal> normals;
    std::vector<std::uint8_t> echoes;
    const auto begin = [&](const Stretch& s) {
      normals = s.read(store_, columns::kNormals);
      echoes = s.read(store_, columns::kEchoes);
    };
    for_points(tile, kMaskHalo, begin, [&](std::size_t i, Index3 p) {
      const std::size_t at = pixel_in(tile, kMaskHalo, p);
      if (height(p.z) - ground.values[at] < params_.least_height * 1000) return;
      const PackedNormal& n = normals[i];
      const bool has_normal = n.x != 0 || n.y != 0 || n.z != 0;
      ++pixels[at].high;
      pixels[at].smooth +=
          has_normal && n.curvature <= params_.smoothness * 3 * 65535 && (echoes[i] & kMultipleReturns) == 0;
    });
    const std::vector<std::uint8_t> mask = building_mask(pixels, kAround, kAround);
    return without_halo({kAround, kAround, {mask.begin(), mask.end()}}, kMaskHalo);
  }

  struct Found {
    Image ground, buildings;
  };

  RoleCounts rewrite(std::uint32_t block) const {
    auto roles = store_.read(block, columns::kRole);
    const auto codes = store_.read(block, columns::kCodes);
    std::map<std::size_t, Found> tiles;
    RoleCounts counts{};
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (roles[i] == PointRole::unclassified) {
        const Index3 p = index_of({store_.blocks()[block].node.tile, codes[i]});
        const std::size_t tile = raster().tile_over(p);
        auto entry = tiles.find(tile);
        if (entry == tiles.end())
          entry =
              tiles.emplace(tile, Found{layer_tile(layers(), "ground", tile), layer_tile(layers(), "buildings", tile)})
                  .first;
        roles[i] = role_of(entry->second, pixel_in(tile, 0, p), p);
      }
      ++counts[static_cast<std::size_t>(roles[i])];
    }
    store_.write(block, columns::kRole, roles);
    return counts;
  }

  PointRole role_of(const Found& found, std::size_t pixel, Index3 p) const {
    const double above = (height(p.z) - found.ground.values[pixel]) / 1000.0;
    if (above <= params_.ground_within) return PointRole::ground;
    return above >= params_.least_height && found.buildings.values[pixel] != 0 ? PointRole::building
                                                                               : PointRole::unclassified;
  }

  const Store& store_;
  const FoundRolesParams& params_;
  const PassContext& context_;
  double unit_mm_;
  RasterLayers tiles_;
  LatticeCells pixel_of_;
};

}  // namespace

RoleCounts find_roles(const Store& store, const FoundRolesParams& params, const PassContext& context) {
  return RoleFinder(store, params, context).find();
}

}  // namespace ilot
