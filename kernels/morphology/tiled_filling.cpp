// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/tiled_filling.h"

#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <utility>

#include "kernels/morphology/radix_heap.h"
#include "kernels/rasters/padded.h"

namespace ilot {
namespace {

// Calls take(q) for the neighbours of a pixel within the image.
template <class Take>
void for_neighbours(const Image& image, std::size_t p, Adjacency adjacency, const Take& take) {
  const auto width = std::int64_t{image.width}, x = static_cast<std::int64_t>(p) % width,
             y = static_cast<std::int64_t>(p) / width;
  for (std::int64_t v = std::max<std::int64_t>(y - 1, 0); v <= y + 1 && v < image.height; ++v)
    for (std::int64_t u = std::max<std::int64_t>(x - 1, 0); u <= x + 1 && u < width; ++u)
      if ((u != x || v != y) && (adjacency == Adjacency::eight || u == x || v == y))
        take(static_cast<std::size_t>(v * width + u));
}

struct Link {
  std::uint32_t to;
  Height height;
};

// The spills of a tile by the pixels that they join, in both directions. Those of pixel i are links [from[i], from[i +
// 1]).
struct LinkedSpills {
  std::vector<std::uint32_t> from;
  std::vector<Link> links;
};

LinkedSpills linked(const std::vector<SpillEdge>& spills, std::uint32_t pixels) {
  LinkedSpills out{std::vector<std::uint32_t>(std::size_t{pixels} + 1, 0), std::vector<Link>(2 * spills.size())};
  for (const SpillEdge& e : spills) ++out.from[e.a + 1], ++out.from[e.b + 1];
  std::partial_sum(out.from.begin(), out.from.end(), out.from.begin());
  std::vector<std::uint32_t> at = out.from;
  for (const SpillEdge& e : spills) {
    out.links[at[e.a]++] = {e.b, e.height};
    out.links[at[e.b]++] = {e.a, e.height};
  }
  return out;
}

}  // namespace

TiledFilling::TiledFilling(const TileGrid& grid, Adjacency adjacency, SpillStore spills)
    : adjacency_(adjacency),
      pixels_(grid),
      store_(std::move(spills)),
      spills_(store_.write ? 0 : grid.count()),
      mask_(pixels_.size()),
      reached_(pixels_.size(), kAboveAll),
      open_(pixels_.size(), 0) {}

Image TiledFilling::fill(std::size_t tile, const Image& image) {
  BorderFlood flood = flood_from_border(image, adjacency_);
  if (store_.write)
    store_.write(tile, std::move(flood.spills));
  else
    spills_[tile] = std::move(flood.spills);
  const std::vector<Height> heights = heights_on(pixels_.perimeter(tile), image);
  std::copy(heights.begin(), heights.end(), mask_.begin() + pixels_.first(tile));
  for (std::uint32_t i = 0; i < heights.size(); ++i) {
    if (!pixels_.ends_at(tile, i)) continue;
    reached_[pixels_.first(tile) + i] = heights[i];
    open_[pixels_.first(tile) + i] = 1;
  }
  return std::move(flood.level);
}

void TiledFilling::join() {
  propagate();
}

// A pixel below the filling of a border pixel that is joined to it below that height is filled to the same height.
// Otherwise the spill between their two basins would have let the water out.
bool TiledFilling::raise(std::size_t tile, Image& filled) const {
  const Perimeter perimeter = pixels_.perimeter(tile);
  std::vector<std::uint32_t> raised;
  bool any = false;
  for (std::uint32_t i = 0; i < perimeter.size(); ++i) {
    const auto [x, y] = perimeter.place(i);
    const auto p = static_cast<std::uint32_t>(y * filled.width + x);
    const Height level = reached_[pixels_.first(tile) + i];
    if (level <= filled.values[p]) continue;
    filled.values[p] = level;
    any = true;
    raised.push_back(p);
    while (!raised.empty()) {
      const std::uint32_t at = raised.back();
      raised.pop_back();
      for_neighbours(filled, at, adjacency_, [&](std::size_t q) {
        if (filled.values[q] >= level) return;
        filled.values[q] = level;
        raised.push_back(static_cast<std::uint32_t>(q));
      });
    }
  }
  return any;
}

void TiledFilling::record_drained(std::size_t tile, const Image& drained) {
  const std::vector<Height> heights = heights_on(pixels_.perimeter(tile), drained);
  for (std::uint32_t i = 0; i < heights.size(); ++i) {
    Height& reached = reached_[pixels_.first(tile) + i];
    if (heights[i] >= reached) continue;
    reached = heights[i];
    open_[pixels_.first(tile) + i] = 1;
  }
}

void TiledFilling::join_drained() {
  propagate();
}

void TiledFilling::lower(std::size_t tile, const Image& image, Image& drained) const {
  const Perimeter perimeter = pixels_.perimeter(tile);
  RadixHeap queue;
  for (std::uint32_t i = 0; i < perimeter.size(); ++i) {
    const auto [x, y] = perimeter.place(i);
    const auto p = static_cast<std::uint32_t>(y * drained.width + x);
    const Height level = reached_[pixels_.first(tile) + i];
    if (level >= drained.values[p]) continue;
    drained.values[p] = level;
    queue.push(level, p);
  }
  while (!queue.empty()) {
    const RadixHeap::Item item = queue.pop();
    if (drained.values[item.pixel] != item.height()) continue;  // it was lowered since
    for_neighbours(drained, item.pixel, adjacency_, [&](std::size_t q) {
      const Height level = std::max(item.height(), image.values[q]);
      if (level >= drained.values[q]) return;
      drained.values[q] = level;
      queue.push(level, static_cast<std::uint32_t>(q));
    });
  }
}

// Tiles from which others may still be reached, by the lowest of their open pixels. Some tiles are listed more than
// once.
struct TiledFilling::Pending {
  using Entry = std::pair<Height, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> tiles;
};

// Lowers the value at which each pixel is reached, starting from the open pixels of any tile. It goes tile by tile, the
// one with the lowest open pixel first, until no pixel is open. Heights are only lowered, down to the minimum, so the
// order does not matter.
void TiledFilling::propagate() {
  Pending pending;
  for (std::size_t t = 0; t < pixels_.grid().count(); ++t) {
    const std::uint32_t first = pixels_.first(t), end = first + pixels_.perimeter(t).size();
    Height low = kAboveAll;
    bool any = false;
    for (std::uint32_t p = first; p < end; ++p)
      if (open_[p] != 0) any = true, low = std::min(low, reached_[p]);
    if (any) pending.tiles.push({low, t});
  }
  while (!pending.tiles.empty()) {
    const std::size_t tile = pending.tiles.top().second;
    pending.tiles.pop();
    propagate_tile(tile, pending);
  }
}

// Goes from the open pixels of a tile through its spills, and to the tiles beside it.
void TiledFilling::propagate_tile(std::size_t tile, Pending& pending) {
  const std::uint32_t first = pixels_.first(tile), count = pixels_.perimeter(tile).size();
  RadixHeap queue;
  for (std::uint32_t i = 0; i < count; ++i)
    if (open_[first + i] != 0) queue.push(reached_[first + i], i);
  if (queue.empty()) return;
  std::fill_n(open_.begin() + first, count, std::uint8_t{0});
  const LinkedSpills spills = linked(store_.read ? store_.read(tile) : spills_[tile], count);
  std::map<std::size_t, Height> touched;  // tiles beside it, with their lowest new height
  while (!queue.empty()) {
    const RadixHeap::Item item = queue.pop();
    const Height v = item.height();
    if (reached_[first + item.pixel] != v) continue;  // it was lowered since
    for (std::uint32_t l = spills.from[item.pixel]; l < spills.from[item.pixel + 1]; ++l) {
      const Link& link = spills.links[l];
      const Height through = std::max(v, link.height);
      if (through >= reached_[first + link.to]) continue;
      reached_[first + link.to] = through;
      queue.push(through, link.to);
    }
    pixels_.for_beyond(first + item.pixel, adjacency_, [&](std::uint32_t q) {
      const Height through = std::max(v, mask_[q]);
      if (through >= reached_[q]) return;
      reached_[q] = through;
      open_[q] = 1;
      const auto known = touched.try_emplace(pixels_.tile_of(q), through).first;
      known->second = std::min(known->second, through);
    });
  }
  for (const auto& [other, height] : touched) pending.tiles.push({height, other});
}

}  // namespace ilot
