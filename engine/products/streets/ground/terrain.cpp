// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/terrain.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <vector>

#include "kernels/morphology/flat_zones_tiled.h"
#include "kernels/morphology/outward_drops.h"
#include "kernels/rasters/box_minimum.h"
#include "kernels/rasters/nearest.h"

namespace ilot {
namespace {

constexpr std::uint32_t kPit = 1;     // cells; half width of what may be a lone pit
constexpr std::uint32_t kRing = 2;    // cells; half width of each of the boxes around it
constexpr std::uint32_t kSmooth = 3;  // cells; half width of the box over which the terrain below objects is a mean
constexpr std::uint32_t kPitHalo = kPit + 2 * kRing + 1;
// Choice: most of a surface; a hall more than twice as wide as `reach` has as many sure cells.
constexpr double kSureShare = 0.5;  // of a surface that is ground
// Choice: a hilltop stands above its surroundings and has no edges; the middle of a low wide roof has them all around.
constexpr double kNearlyAllShare = 0.95;  // of a surface that may stand above its surroundings

// A zone of lowest heights, over all tiles.
struct Surface {
  std::uint64_t cells = 0, sure = 0;
  std::int64_t drops = 0;   // outward drops
  std::int64_t height = 0;  // sum of the heights above the envelope

  // `terrace`: number of cells of the smallest terrace; `low`: greatest mean height of one.
  bool is_ground(double terrace, Height low) const {
    const auto n = static_cast<double>(cells), s = static_cast<double>(sure);
    if (s >= kSureShare * n && (drops <= 0 || s >= kNearlyAllShare * n)) return true;
    return n >= terrace && static_cast<double>(height) <= n * low;
  }
};

// The lowest heights of a tile without lone pits. `around` has kPitHalo more cells on all sides.
Image without_pits(const Image& around, Height deepest) {
  const Image boxes = box_minimum(around, kRing);
  const std::uint32_t w = around.width, h = around.height;
  Image out = without_halo(around, kPitHalo);
  constexpr std::int64_t kStep = kPit + kRing + 1;
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x) {
      Height& own = out.values[std::size_t{y} * out.width + x];
      if (own == kNoHeight) continue;
      Height least = kAboveAll;
      std::uint32_t known = 0;
      for (std::int64_t dy = -kStep; dy <= kStep; dy += kStep)
        for (std::int64_t dx = -kStep; dx <= kStep; dx += kStep) {
          if (dx == 0 && dy == 0) continue;
          const auto u = static_cast<std::size_t>(std::int64_t{x} + kPitHalo + dx),
                     v = static_cast<std::size_t>(std::int64_t{y} + kPitHalo + dy);
          const Height box = boxes.values[v * w + u];
          known += box != kNoHeight;
          least = std::min(least, or_highest(box));
        }
      if (known > 4 && own < least - deepest) own = kNoHeight;
    }
  static_cast<void>(h);
  return out;
}

// The lowest of own + rise * (|dx| + |dy|) over all cells of an image, in two sweeps along rows and two along columns.
Image envelope_of(const Image& floor, Height rise) {
  Image out = floor;
  for (Height& v : out.values) v = or_highest(v);
  const std::size_t w = out.width, h = out.height;
  const auto pull = [rise](Height& to, Height from) {
    if (from != kAboveAll) to = std::min(to, from + rise);
  };
  for (std::size_t y = 0; y < h; ++y) {
    Height* row = out.values.data() + y * w;
    for (std::size_t x = 1; x < w; ++x) pull(row[x], row[x - 1]);
    for (std::size_t x = w - 1; x > 0; --x) pull(row[x - 1], row[x]);
  }
  for (std::size_t y = 1; y < h; ++y)
    for (std::size_t x = 0; x < w; ++x) pull(out.values[y * w + x], out.values[(y - 1) * w + x]);
  for (std::size_t y = h - 1; y > 0; --y)
    for (std::size_t x = 0; x < w; ++x) pull(out.values[(y - 1) * w + x], out.values[y * w + x]);
  for (Height& v : out.values) v = v == kAboveAll ? kNoHeight : v;
  return out;
}

class TerrainFinder {
 public:
  TerrainFinder(const Cells& cells, const TerrainParams& params)
      : layers_(cells.layers),
        reach_(std::max(1u, cells.scale.pixels(params.reach))),
        rise_of_envelope_(std::max(1, cells.scale.units(params.steepest * cells.scale.pixel))),
        step_(cells.scale.units(params.step)),
        highest_(cells.scale.units(params.highest)),
        deepest_(cells.scale.units(params.deepest_pit)),
        low_(cells.scale.units(params.terrace_height)),
        terrace_(params.terrace / (cells.scale.pixel * cells.scale.pixel)),
        least_raised_(params.least_raised / (cells.scale.pixel * cells.scale.pixel)),
        // Neighbours on a slope differ by its rise over the diagonal of a cell.
        lambda_(cells.scale.units(params.rise + params.steepest * 1.5 * cells.scale.pixel)) {}

  TerrainCounts find() {
    for_each_tile(layers_.grid,
                  [&](std::size_t tile) {
                    layers_.write("floor", tile,
                                  without_pits(layer_around(layers_, "lowest", tile, kPitHalo), deepest_));
                  },
                  {24, kPitHalo});
    for_each_tile(layers_.grid,
                  [&](std::size_t tile) {
                    const Image envelope = envelope_of(layer_around(layers_, "floor", tile, reach_), rise_of_envelope_);
                    layers_.write("envelope", tile, without_halo(envelope, reach_));
                  },
                  {16, reach_});
    find_surfaces();
    find_raised();
    for_each_tile(layers_.grid, [&](std::size_t tile) { write_ground(tile); });
    for_each_tile(layers_.grid, [&](std::size_t tile) { layers_.write("terrain", tile, continued(tile)); },
                  {24, reach_ + kSmooth});
    for (const char* layer : {"floor", "envelope", "surfaces", "raised cells", "bare cells"}) layers_.drop(layer);
    return counts_;
  }

 private:
  void find_surfaces() {
    const ZoneSizes sizes = flat_zones_tiled(
        layers_.grid, lambda_, Adjacency::eight, reader_of(layers_, "floor"),
        [&](std::size_t tile, const PixelLabels& labels) {
          layers_.write("surfaces", tile, {labels.width, labels.height, {labels.of.begin(), labels.of.end()}});
        });
    surfaces_.assign(sizes.pixels.size(), {});
    for_each_tile(layers_.grid, [&](std::size_t tile) { count(tile); }, {40, 1});
  }

  // Whether a cell is on a surface that is ground without being sure.
  bool is_raised(Height floor, Height envelope, Height surface) const {
    return floor != kNoHeight && floor - envelope > step_ && floor - envelope <= highest_ &&
           surfaces_[static_cast<std::uint32_t>(surface)].is_ground(terrace_, low_);
  }

  // Connects the raised cells. Small groups of them are objects that a chain of small steps joins to the ground, as the
  // bumper, the bonnet and the roof of a car.
  void find_raised() {
    const auto raised = [&](std::size_t tile) {
      Image floor = layer_tile(layers_, "floor", tile);
      const Image envelope = layer_tile(layers_, "envelope", tile), of = layer_tile(layers_, "surfaces", tile);
      for (std::size_t i = 0; i < floor.size(); ++i)
        floor.values[i] = is_raised(floor.values[i], envelope.values[i], of.values[i]) ? 0 : kNoHeight;
      return floor;
    };
    raised_ =
        flat_zones_tiled(layers_.grid, 0, Adjacency::eight, raised, [&](std::size_t tile, const PixelLabels& labels) {
          layers_.write("raised cells", tile, {labels.width, labels.height, {labels.of.begin(), labels.of.end()}});
        });
  }

  // Adds what a tile has of each surface.
  void count(std::size_t tile) {
    const Image floor = layer_around(layers_, "floor", tile, 1), of = layer_around(layers_, "surfaces", tile, 1),
                envelope = layer_tile(layers_, "envelope", tile);
    std::vector<std::pair<std::uint32_t, Surface>> runs;
    const std::size_t w = floor.width;
    for (std::uint32_t y = 0; y < envelope.height; ++y)
      for (std::uint32_t x = 0; x < envelope.width; ++x) {
        const std::size_t i = (std::size_t{y} + 1) * w + x + 1;
        if (floor.values[i] == kNoHeight) continue;
        const auto surface = static_cast<std::uint32_t>(of.values[i]);
        if (runs.empty() || runs.back().first != surface) runs.push_back({surface, {}});
        Surface& s = runs.back().second;
        ++s.cells;
        const Height above = floor.values[i] - envelope.values[std::size_t{y} * envelope.width + x];
        s.sure += above <= step_;
        s.height += above;
        for (const std::size_t j : {i - w - 1, i - w, i - w + 1, i - 1, i + 1, i + w - 1, i + w, i + w + 1})
          if (of.values[j] != of.values[i]) s.drops += outward_drop(floor.values[i], floor.values[j], lambda_);
      }
    const std::lock_guard lock(mutex_);
    for (const auto& [surface, s] : runs) {
      surfaces_[surface].cells += s.cells;
      surfaces_[surface].sure += s.sure;
      surfaces_[surface].drops += s.drops;
      surfaces_[surface].height += s.height;
    }
  }

  // Writes the heights of the cells that are ground.
  void write_ground(std::size_t tile) {
    Image floor = layer_tile(layers_, "floor", tile);
    const Image envelope = layer_tile(layers_, "envelope", tile), of = layer_tile(layers_, "surfaces", tile),
                raised = layer_tile(layers_, "raised cells", tile);
    TerrainCounts own;
    for (std::size_t i = 0; i < floor.size(); ++i) {
      if (floor.values[i] == kNoHeight) continue;
      ++own.cells;
      const bool small =
          raised.values[i] > 0 &&
          static_cast<double>(raised_.pixels[static_cast<std::size_t>(raised.values[i])]) < least_raised_;
      if (small || floor.values[i] - envelope.values[i] > highest_ ||
          !surfaces_[static_cast<std::uint32_t>(of.values[i])].is_ground(terrace_, low_))
        floor.values[i] = kNoHeight;
      else
        ++own.ground;
    }
    layers_.write("bare cells", tile, floor);
    const std::lock_guard lock(mutex_);
    counts_.cells += own.cells;
    counts_.ground += own.ground;
  }

  // The terrain of a tile: the ground; where there is none, the mean around of the nearest ground, else the envelope.
  Image continued(std::size_t tile) const {
    const std::uint32_t halo = reach_ + kSmooth;
    const Image around = layer_around(layers_, "bare cells", tile, halo);
    Image out = layer_tile(layers_, "envelope", tile);
    with_nearest_keys(around, reach_, [&](const auto& nearest) {
      for (std::uint32_t y = 0; y < out.height; ++y)
        for (std::uint32_t x = 0; x < out.width; ++x) {
          const std::size_t i = (std::size_t{y} + halo) * around.width + x + halo;
          Height& to = out.values[std::size_t{y} * out.width + x];
          if (around.values[i] != kNoHeight)
            to = around.values[i];
          else if (nearest.any(i))
            to = mean_of_nearest(around, nearest, i);
        }
      return 0;
    });
    return out;
  }

  // The mean of the nearest ground of the cells around one. A slope goes on below what stands on it without a step.
  template <class Nearest>
  static Height mean_of_nearest(const Image& around, const Nearest& nearest, std::size_t i) {
    std::int64_t sum = 0, n = 0;
    for (std::size_t v = 0; v <= 2 * kSmooth; ++v)
      for (std::size_t u = 0; u <= 2 * kSmooth; ++u) {
        const std::size_t j = i + v * around.width + u - kSmooth * (around.width + std::size_t{1});
        if (nearest.any(j)) sum += around.values[nearest.pixel(j)], ++n;
      }
    return static_cast<Height>(sum / n);
  }

  const TileLayers& layers_;
  std::uint32_t reach_;
  Height rise_of_envelope_, step_, highest_, deepest_, low_;
  double terrace_, least_raised_;  // cells
  Height lambda_;
  std::vector<Surface> surfaces_;
  ZoneSizes raised_;
  TerrainCounts counts_;
  std::mutex mutex_;
};

}  // namespace

TerrainCounts find_terrain(const Cells& cells, const TerrainParams& params) {
  return TerrainFinder(cells, params).find();
}

}  // namespace ilot
