// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/perimeter.h"

#include <algorithm>
#include <utility>

#include "kernels/core/union_find.h"
#include "kernels/morphology/level_queue.h"
#include "kernels/morphology/radix_heap.h"
#include "kernels/morphology/zone_runs.h"
#include "kernels/rasters/padded.h"

namespace ilot {
namespace {

// The state of a pixel before water passes over it. A wet pixel was reached from a basin, and its state includes the
// number of that basin.
constexpr std::uint32_t kDry = 0xffffffffu, kOutside = 0xfffffffeu, kWet = 0x80000000u;

// Queue is RadixHeap or LevelQueue.
template <class Queue>
class PerimeterFlood {
 public:
  PerimeterFlood(const Image& image, Adjacency adjacency, Queue queue)
      : frame_(image.width, image.height),
        perimeter_{image.width, image.height},
        adjacency_(adjacency),
        neighbours_(step_count(adjacency)),
        steps_(frame_.steps()),
        level_(padded(image, kAboveAll)),
        basin_(frame_.size(), kOutside),
        parents_(perimeter_.size()),
        trees_(parents_),
        queue_(std::move(queue)) {
    for (std::uint32_t y = 0; y < image.height; ++y) std::fill_n(basin_.begin() + at(0, y), image.width, kDry);
  }

  BorderFlood run(const ZoneRuns& missing) {
    flood_missing(missing);
    for (std::uint32_t i = 0; i < perimeter_.size(); ++i) {
      const auto [x, y] = perimeter_.place(i);
      const auto p = static_cast<std::uint32_t>(at(x, y));
      if (basin_[p] != kDry && (basin_[p] & kWet) == 0) continue;
      if (basin_[p] == kDry) queue_.push(level_[p], p);  // a wet pixel waits on the shore of a region without heights
      basin_[p] = i | kWet;
    }
    while (!queue_.empty()) {
      const auto item = queue_.pop();
      under_water_.push_back(item.pixel);
      while (!under_water_.empty()) {
        const std::uint32_t p = under_water_.back();
        under_water_.pop_back();
        pass(p, item.height());
      }
    }
    return {{frame_.width, frame_.height, unpadded<Height>(frame_, level_)}, std::move(spills_)};
  }

 private:
  std::ptrdiff_t at(std::uint32_t x, std::uint32_t y) const { return static_cast<std::ptrdiff_t>(frame_.row(y) + x); }

  // Floods the regions without a height that reach the perimeter. Each belongs to one basin, the first that it touches.
  void flood_missing(const ZoneRuns& missing) {
    std::vector<std::uint32_t> basins(std::size_t{missing.count} + 1, kDry);
    const auto join = [&](std::uint32_t zone, std::uint32_t x, std::uint32_t y) {
      const std::uint32_t i = perimeter_.index(x, y);
      if (basins[zone] == kDry) basins[zone] = i;
      if (trees_.unite(basins[zone], i)) spills_.push_back({basins[zone], i, kNoHeight});
    };
    for_each_run(missing, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
      if (y == 0 || y + 1 == frame_.height)
        for (std::uint32_t x = run.from; x < run.to; ++x) join(zone, x, y);
      if (run.from == 0) join(zone, 0, y);
      if (run.to == frame_.width) join(zone, frame_.width - 1, y);
    });
    for_each_run(missing, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
      if (basins[zone] != kDry)
        std::fill(basin_.begin() + at(run.from, y), basin_.begin() + at(run.to, y), basins[zone]);
    });
    for_each_run(missing, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
      if (basins[zone] != kDry) wet_around(basins[zone], y, run);
    });
  }

  void wet_around(std::uint32_t basin, std::uint32_t y, PixelRun run) {
    const std::ptrdiff_t corner = adjacency_ == Adjacency::eight ? 1 : 0;
    const std::ptrdiff_t from = at(run.from, y), to = at(run.to, y), stride = frame_.stride;
    wet_if_dry(basin, from - 1, from);
    wet_if_dry(basin, to, to + 1);
    wet_if_dry(basin, from - corner - stride, to + corner - stride);
    wet_if_dry(basin, from - corner + stride, to + corner + stride);
  }

  void wet_if_dry(std::uint32_t basin, std::ptrdiff_t from, std::ptrdiff_t to) {
    for (auto q = static_cast<std::uint32_t>(from); q < static_cast<std::uint32_t>(to); ++q) {
      if (basin_[q] != kDry) continue;
      basin_[q] = basin | kWet;
      queue_.push(level_[q], q);
    }
  }

  // Levels of passed pixels never fall from one call to the next.
  void pass(std::uint32_t p, Height level) {
    const std::uint32_t basin = basin_[p] & ~kWet;
    basin_[p] = basin;
    level_[p] = level;
    for (std::size_t s = 0; s < neighbours_; ++s) {
      const std::uint32_t q = p + steps_[s], other = basin_[q];
      if ((other & ~kWet) == basin) continue;
      if (other == kDry) {
        basin_[q] = basin | kWet;
        if (level_[q] <= level)
          under_water_.push_back(q);
        else
          queue_.push(level_[q], q);
      } else if ((other & kWet) == 0 && trees_.unite(basin, other)) {
        spills_.push_back({basin, other, level});
      }
    }
  }

  PaddedFrame frame_;
  Perimeter perimeter_;
  Adjacency adjacency_;
  std::size_t neighbours_;
  std::array<std::uint32_t, 8> steps_;
  std::vector<Height> level_;
  std::vector<std::uint32_t> basin_;
  std::vector<std::uint32_t> parents_;
  UnionFind trees_;
  Queue queue_;
  std::vector<std::uint32_t> under_water_;
  std::vector<SpillEdge> spills_;
};

}  // namespace

std::vector<Height> heights_on(const Perimeter& perimeter, const Image& image) {
  std::vector<Height> out(perimeter.size());
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const auto [x, y] = perimeter.place(i);
    out[i] = image.values[std::size_t{y} * image.width + x];
  }
  return out;
}

BorderFlood flood_from_border(const Image& image, Adjacency adjacency) {
  if (image.size() == 0) return {};
  constexpr std::uint32_t kMostLevels = 1u << 20;
  Height low = kAboveAll, top = kNoHeight;
  for (const Height v : image.values) {
    low = std::min(low, v == kNoHeight ? kAboveAll : v);
    top = std::max(top, v);
  }
  const ZoneRuns missing = missing_runs(image, adjacency);
  const std::uint32_t range = static_cast<std::uint32_t>(top) - static_cast<std::uint32_t>(low);
  if (low <= top && range >= kMostLevels) return PerimeterFlood(image, adjacency, RadixHeap()).run(missing);
  const std::size_t pixels = PaddedFrame(image.width, image.height).size();
  return PerimeterFlood(image, adjacency, LevelQueue(low, low <= top ? range + 1 : 0, pixels)).run(missing);
}

}  // namespace ilot
