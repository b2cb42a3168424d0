// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/found_roles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/columns/building_mask.h"
#include "engine/columns/ground_surface.h"
#include "engine/pass/pass.h"
#include "engine/store/stretches.h"
#include "kernels/geometry/box3.h"
#include "kernels/neighbours/normals.h"

namespace ilot {
namespace {

constexpr std::int64_t kTilePixels = 128;
constexpr double kPixelMetres = 1.1;              // at most
constexpr double kGroundWithin = 0.5, kHigh = 2;  // metres above the ground's surface
constexpr double kSmooth = 0.06;                  // greatest curvature of a roof's points
constexpr std::uint64_t kBytesPerPoint = 32, kBytesOfTile = 8u << 20;
static_assert(kGroundHalo <= kTilePixels, "the eight tiles around must hold the halo");

using TileKey = std::pair<std::int64_t, std::int64_t>;  // row, column

// The raster that all tiles share.
struct Raster {
  int pixel_bits = 0;
  double unit_mm = 1;

  Raster(const Store& store, const PassContext& context) : unit_mm(store.unit() * context.metres_per_unit * 1000) {
    while (pixel_bits < kTileBits && std::ldexp(unit_mm, pixel_bits + 1) <= kPixelMetres * 1000) ++pixel_bits;
  }
  std::int64_t pixel(std::int64_t v) const { return v >> pixel_bits; }
  std::int64_t tile(std::int64_t v) const { return pixel(v) >> 7; }
  double pixel_mm() const { return std::ldexp(unit_mm, pixel_bits); }
  Height height(std::int64_t z) const { return static_cast<Height>(std::lround(static_cast<double>(z) * unit_mm)); }
  // Columns over a tile and so many pixels around it.
  IndexBox box(TileKey t, std::int64_t halo) const {
    const auto low = [&](std::int64_t i) { return (i * kTilePixels - halo) * (std::int64_t{1} << pixel_bits); };
    const auto high = [&](std::int64_t i) {
      return ((i + 1) * kTilePixels + halo) * (std::int64_t{1} << pixel_bits) - 1;
    };
    return column_over(low(t.second), low(t.first), high(t.second), high(t.first));
  }
};
static_assert(kTilePixels == 1 << 7);

class RoleFinder {
 public:
  RoleFinder(const Store& store, const PassContext& context)
      : store_(store), context_(context), raster_(store, context) {
    find_tiles();
    std::filesystem::remove_all(folder());
    std::filesystem::create_directories(folder());
  }

  RoleCounts find() {
    for_each_tile([&](TileKey t) { write_column<Height>(path("lowest", t), lowest(t).values); });
    for_each_tile([&](TileKey t) { write_column<Height>(path("ground", t), ground(t).values); });
    for_each_tile([&](TileKey t) { write_column<std::uint8_t>(path("mask", t), mask(t)); });
    std::vector<PassTask> tasks;
    for (const Block& b : store_.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
    std::vector<RoleCounts> counts(tasks.size());
    run_pass(tasks, context_.budget_bytes, [&](std::size_t i) { counts[i] = rewrite(static_cast<std::uint32_t>(i)); });
    RoleCounts all{};
    for (const RoleCounts& c : counts)
      for (std::size_t role = 0; role < all.size(); ++role) all[role] += c[role];
    return all;
  }

 private:
  // Those with points in them: a few points far from all others must not bring what is between.
  void find_tiles() {
    std::vector<PassTask> tasks;
    for (const Block& b : store_.blocks()) tasks.push_back({std::uint64_t{1} << 20, b.points});
    std::vector<std::vector<TileKey>> of_block(tasks.size());
    run_pass(tasks, context_.budget_bytes, [&](std::size_t i) {
      std::vector<TileKey>& keys = of_block[i];
      const auto block = static_cast<std::uint32_t>(i);
      const Slice whole{block, 0, store_.blocks()[i].points, 0};
      for_each_stretch(store_, std::span(&whole, 1), [&](const Stretch& s) {
        for (std::size_t n = 0; n < s.codes.size(); ++n) {
          const Index3 p = s.position(n);
          const TileKey key{raster_.tile(p.y), raster_.tile(p.x)};
          if (keys.empty() || keys.back() != key) keys.push_back(key);
        }
        std::sort(keys.begin(), keys.end());
        keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
      });
    });
    for (const auto& keys : of_block) tiles_.insert(keys.begin(), keys.end());
  }

  std::filesystem::path folder() const { return store_.folder() / "ground"; }
  std::filesystem::path path(const char* what, TileKey t) const {
    return folder() / (std::string(what) + "_" + std::to_string(t.first) + "_" + std::to_string(t.second));
  }

  void for_each_tile(const std::function<void(TileKey)>& body) const {
    const std::vector<TileKey> list(tiles_.begin(), tiles_.end());
    const std::vector<PassTask> tasks(list.size(), PassTask{kBytesOfTile, 1});
    run_pass(tasks, context_.budget_bytes, [&](std::size_t i) { body(list[i]); });
  }

  // Calls visit(position, block, point) for all points in a box, a stretch at a time.
  template <class Visit>
  void for_each_point(const IndexBox& box, const Visit& visit) const {
    for_each_stretch(store_, plan_view(store_, box, {}).slices, [&](const Stretch& s) {
      const auto at = visit.stretch(s);
      for (std::size_t i = 0; i < s.codes.size(); ++i)
        if (const Index3 p = s.position(i); box.contains(p)) visit.point(p, at, i);
    });
  }

  Image lowest(TileKey t) const {
    struct Lowest {
      const Raster& raster;
      TileKey tile;
      Image& image;
      int stretch(const Stretch&) const { return 0; }
      void point(Index3 p, int, std::size_t) const {
        const std::int64_t x = raster.pixel(p.x) - tile.second * kTilePixels,
                           y = raster.pixel(p.y) - tile.first * kTilePixels;
        Height& v = image.values[static_cast<std::size_t>(y * kTilePixels + x)];
        const Height z = raster.height(p.z);
        if (v == kNoHeight || z < v) v = z;
      }
    };
    Image image = filled_image(kTilePixels, kTilePixels, kNoHeight);
    for_each_point(raster_.box(t, 0), Lowest{raster_, t, image});
    return image;
  }

  // A tile and so many pixels around it, out of what was written tile by tile.
  Image around(const char* what, TileKey t, std::int64_t halo) const {
    const std::int64_t side = kTilePixels + 2 * halo;
    Image image = filled_image(static_cast<std::uint32_t>(side), static_cast<std::uint32_t>(side), kNoHeight);
    for (std::int64_t row = t.first - 1; row <= t.first + 1; ++row) {
      for (std::int64_t column = t.second - 1; column <= t.second + 1; ++column) {
        if (tiles_.count({row, column}) == 0) continue;
        const auto part = read_column<Height>(path(what, {row, column}));
        const std::int64_t dy = (row - t.first) * kTilePixels + halo, dx = (column - t.second) * kTilePixels + halo;
        for (std::int64_t y = std::max<std::int64_t>(0, -dy); y < kTilePixels && y + dy < side; ++y)
          for (std::int64_t x = std::max<std::int64_t>(0, -dx); x < kTilePixels && x + dx < side; ++x)
            image.values[static_cast<std::size_t>((y + dy) * side + x + dx)] =
                part[static_cast<std::size_t>(y * kTilePixels + x)];
      }
    }
    return image;
  }

  static Image core(const Image& image, std::int64_t halo) {
    Image part = filled_image(kTilePixels, kTilePixels, kNoHeight);
    for (std::int64_t y = 0; y < kTilePixels; ++y)
      for (std::int64_t x = 0; x < kTilePixels; ++x)
        part.values[static_cast<std::size_t>(y * kTilePixels + x)] =
            image.values[static_cast<std::size_t>((y + halo) * image.width + x + halo)];
    return part;
  }

  Image ground(TileKey t) const {
    GroundSurfaceParams params;
    params.pixel_mm = raster_.pixel_mm();
    return core(ground_surface(around("lowest", t, kGroundHalo), params), kGroundHalo);
  }

  std::vector<std::uint8_t> mask(TileKey t) const {
    constexpr std::int64_t kSide = kTilePixels + 2 * std::int64_t{kMaskHalo};
    struct Columns {
      std::vector<PackedNormal> normals;
      std::vector<std::uint8_t> echoes;
    };
    struct High {
      const Store& store;
      const Raster& raster;
      TileKey tile;
      const Image& ground;
      std::vector<HighPoints>& pixels;
      Columns stretch(const Stretch& s) const {
        return {s.read(store, columns::kNormals), s.read(store, columns::kEchoes)};
      }
      void point(Index3 p, const Columns& columns, std::size_t i) const {
        const std::int64_t x = raster.pixel(p.x) - tile.second * kTilePixels + kMaskHalo;
        const std::int64_t y = raster.pixel(p.y) - tile.first * kTilePixels + kMaskHalo;
        const auto at = static_cast<std::size_t>(y * kSide + x);
        if (raster.height(p.z) - ground.values[at] < kHigh * 1000) return;
        const PackedNormal& n = columns.normals[i];
        const bool has_normal = n.x != 0 || n.y != 0 || n.z != 0;
        ++pixels[at].high;
        pixels[at].smooth +=
            has_normal && n.curvature <= kSmooth * 3 * 65535 && (columns.echoes[i] & kOneOfSeveral) == 0;
      }
    };
    const Image ground = around("ground", t, kMaskHalo);
    std::vector<HighPoints> pixels(static_cast<std::size_t>(kSide * kSide));
    for_each_point(raster_.box(t, kMaskHalo), High{store_, raster_, t, ground, pixels});
    const auto whole = building_mask(pixels, kSide, kSide);
    std::vector<std::uint8_t> part;
    for (std::int64_t y = 0; y < kTilePixels; ++y)
      for (std::int64_t x = 0; x < kTilePixels; ++x)
        part.push_back(whole[static_cast<std::size_t>((y + kMaskHalo) * kSide + x + kMaskHalo)]);
    return part;
  }

  struct Found {
    std::vector<Height> ground;
    std::vector<std::uint8_t> mask;
  };

  RoleCounts rewrite(std::uint32_t block) const {
    auto roles = store_.read(block, columns::kRole);
    const auto codes = store_.read(block, columns::kCodes);
    std::map<TileKey, Found> tiles;
    RoleCounts counts{};
    for (std::size_t i = 0; i < roles.size(); ++i) {
      const Index3 p = index_of({store_.blocks()[block].node.tile, codes[i]});
      const TileKey key{raster_.tile(p.y), raster_.tile(p.x)};
      if (roles[i] == PointRole::unclassified) {
        auto entry = tiles.find(key);
        if (entry == tiles.end())
          entry = tiles
                      .emplace(key, Found{read_column<Height>(path("ground", key)),
                                          read_column<std::uint8_t>(path("mask", key))})
                      .first;
        roles[i] = role_of(entry->second, p, key);
      }
      ++counts[static_cast<std::size_t>(roles[i])];
    }
    store_.write(block, columns::kRole, roles);
    return counts;
  }

  PointRole role_of(const Found& found, Index3 p, TileKey t) const {
    const std::int64_t x = raster_.pixel(p.x) - t.second * kTilePixels, y = raster_.pixel(p.y) - t.first * kTilePixels;
    const auto at = static_cast<std::size_t>(y * kTilePixels + x);
    const double above = (raster_.height(p.z) - found.ground[at]) / 1000.0;
    if (above <= kGroundWithin) return PointRole::ground;
    return above >= kHigh && found.mask[at] != 0 ? PointRole::building : PointRole::unclassified;
  }

  const Store& store_;
  const PassContext& context_;
  Raster raster_;
  std::set<TileKey> tiles_;
};

}  // namespace

RoleCounts find_roles(const Store& store, const PassContext& context) {
  return RoleFinder(store, context).find();
}

}  // namespace ilot
