// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/tiled_filling.h"

#include <numeric>

#include "kernels/rasters/padded.h"
#include "kernels/rasters/radix_heap.h"

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

}  // namespace

TiledFilling::TiledFilling(const TileGrid& grid, Adjacency adjacency)
    : adjacency_(adjacency),
      pixels_(grid),
      spills_(grid.count()),
      mask_(pixels_.size()),
      reached_(pixels_.size(), kAboveAll),
      open_(pixels_.size(), 0) {}

Image TiledFilling::fill(std::size_t tile, const Image& image) {
  BorderFlood flood = flood_from_border(image, adjacency_);
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
  link_spills();
  settle();
}

// What lies below the filling of a pixel of the border, and is joined to it below that, is filled as high: otherwise
// the spill between their two basins would have let the water out.
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

void TiledFilling::tell_drained(std::size_t tile, const Image& drained) {
  const std::vector<Height> heights = heights_on(pixels_.perimeter(tile), drained);
  for (std::uint32_t i = 0; i < heights.size(); ++i) {
    Height& reached = reached_[pixels_.first(tile) + i];
    if (heights[i] >= reached) continue;
    reached = heights[i];
    open_[pixels_.first(tile) + i] = 1;
  }
}

void TiledFilling::join_drained() {
  settle();
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
    if (drained.values[item.pixel] != item.height()) continue;  // lowered since
    for_neighbours(drained, item.pixel, adjacency_, [&](std::size_t q) {
      const Height level = std::max(item.height(), image.values[q]);
      if (level >= drained.values[q]) return;
      drained.values[q] = level;
      queue.push(level, static_cast<std::uint32_t>(q));
    });
  }
}

void TiledFilling::link_spills() {
  links_from_.assign(mask_.size() + 1, 0);
  for (std::size_t t = 0; t < spills_.size(); ++t) {
    for (const SpillEdge& e : spills_[t]) {
      ++links_from_[pixels_.first(t) + e.a + 1];
      ++links_from_[pixels_.first(t) + e.b + 1];
    }
  }
  std::partial_sum(links_from_.begin(), links_from_.end(), links_from_.begin());
  links_.resize(links_from_.back());
  auto at = links_from_;
  for (std::size_t t = 0; t < spills_.size(); ++t) {
    for (const SpillEdge& e : spills_[t]) {
      const std::uint32_t a = pixels_.first(t) + e.a, b = pixels_.first(t) + e.b;
      links_[at[a]++] = {b, e.height};
      links_[at[b]++] = {a, e.height};
    }
    std::vector<SpillEdge>().swap(spills_[t]);
  }
}

// Lowers what each pixel is reached at to what reaches it from the open ones of any tile.
void TiledFilling::settle() {
  RadixHeap queue;
  for (std::uint32_t p = 0; p < reached_.size(); ++p)
    if (open_[p] != 0) queue.push(reached_[p], p);
  std::fill(open_.begin(), open_.end(), std::uint8_t{0});
  while (!queue.empty()) {
    const RadixHeap::Item item = queue.pop();
    const Height v = item.height();
    if (reached_[item.pixel] != v) continue;  // lowered since
    const auto reach = [&](std::uint32_t q, Height through) {
      if (through >= reached_[q]) return;
      reached_[q] = through;
      queue.push(through, q);
    };
    for (std::size_t l = links_from_[item.pixel]; l < links_from_[item.pixel + 1]; ++l)
      reach(links_[l].to, std::max(v, links_[l].height));
    pixels_.for_beyond(item.pixel, adjacency_, [&](std::uint32_t q) { reach(q, std::max(v, mask_[q])); });
  }
}

}  // namespace ilot
