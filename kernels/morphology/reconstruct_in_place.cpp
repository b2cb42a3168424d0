// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/reconstruct_in_place.h"

#include "kernels/morphology/radix_heap.h"

namespace ilot {
namespace {

constexpr int kMaxPairs = 4;

// Sets each pixel of row to the minimum of itself and its neighbours in `other`, the row above or below.
template <Adjacency kAdjacency>
void lower_from(const Height* __restrict other, Height* __restrict row, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    Height v = std::min(row[x], other[x]);
    if (kAdjacency == Adjacency::eight) v = std::min(v, std::min(*(other + x - 1), other[x + 1]));
    row[x] = v;
  }
}

void sweep_right(const Height* __restrict f, Height* __restrict g, std::size_t width) {
  Height carried = kAboveAll;
  for (std::size_t x = 0; x < width; ++x) g[x] = carried = std::max(f[x], std::min(g[x], carried));
}

void sweep_left(const Height* __restrict f, Height* __restrict g, std::size_t width) {
  Height carried = kAboveAll;
  for (std::size_t x = width; x-- > 0;) g[x] = carried = std::max(f[x], std::min(g[x], carried));
}

// Marks each p that could still lower a neighbour that the backward scan has already passed: to the right or in the row
// below.
template <Adjacency kAdjacency>
void mark_unstable(const Height* f, const Height* g, std::size_t stride, std::size_t width,
                   std::uint8_t* __restrict unstable) {
  const Height *f_below = f + stride, *g_below = g + stride;
  for (std::size_t x = 0; x < width; ++x) {
    const Height v = g[x];
    unsigned any = g[x + 1] > std::max(v, f[x + 1]);
    any |= g_below[x] > std::max(v, f_below[x]);
    if (kAdjacency == Adjacency::eight) {
      any |= *(g_below + x - 1) > std::max(v, *(f_below + x - 1));
      any |= g_below[x + 1] > std::max(v, f_below[x + 1]);
    }
    unstable[x] = static_cast<std::uint8_t>(any);
  }
}

template <Adjacency kAdjacency>
void scan_forward(const PaddedFrame& frame, const Height* f, Height* g) {
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    Height* row = g + frame.row(y);
    lower_from<kAdjacency>(row - frame.stride, row, frame.width);
    sweep_right(f + frame.row(y), row, frame.width);
  }
}

// Fills `open` with the pixels that are not yet final.
template <Adjacency kAdjacency>
void scan_backward(const PaddedFrame& frame, const Height* f, Height* g, std::vector<std::uint32_t>& open) {
  std::vector<std::uint8_t> unstable(frame.width);
  open.clear();
  for (std::uint32_t y = frame.height; y-- > 0;) {
    const std::size_t first = frame.row(y);
    lower_from<kAdjacency>(g + first + frame.stride, g + first, frame.width);
    sweep_left(f + first, g + first, frame.width);
    mark_unstable<kAdjacency>(f + first, g + first, frame.stride, frame.width, unstable.data());
    for (std::uint32_t x = 0; x < frame.width; ++x)
      if (unstable[x] != 0) open.push_back(static_cast<std::uint32_t>(first + x));
  }
}

void flood(const PaddedFrame& frame, std::size_t neighbours, const Height* f, Height* g, RadixHeap& queue) {
  const auto steps = frame.steps();
  while (!queue.empty()) {
    const RadixHeap::Item item = queue.pop();
    const Height v = item.height();
    if (g[item.pixel] != v) continue;  // it was lowered since
    for (std::size_t s = 0; s < neighbours; ++s) {
      const std::uint32_t q = item.pixel + steps[s];
      const Height lower = std::max(v, f[q]);
      if (lower >= g[q]) continue;
      g[q] = lower;
      queue.push(lower, q);
    }
  }
}

// On noisy ground each pair of scans finishes two thirds of the pixels that the pair before left, in less time than the
// queue takes. Once few pixels are left, or scans do not help, the queue does the rest.
template <Adjacency kAdjacency>
void lower_by_erosion(const PaddedFrame& frame, const Height* f, Height* g) {
  std::vector<std::uint32_t> open;
  std::size_t last = frame.size();
  for (int pair = 0; pair < kMaxPairs; ++pair) {
    scan_forward<kAdjacency>(frame, f, g);
    scan_backward<kAdjacency>(frame, f, g, open);
    if (open.size() < frame.size() / 64 || open.size() > last / 2) break;
    last = open.size();
  }
  RadixHeap queue;
  for (const std::uint32_t p : open) queue.push(g[p], p);
  flood(frame, step_count(kAdjacency), f, g, queue);
}

}  // namespace

void reconstruct_in_place(const PaddedFrame& frame, Adjacency adjacency, std::span<const Height> f,
                          std::span<Height> g) {
  assert(f.size() == frame.size() && g.size() == frame.size());
  adjacency == Adjacency::four ? lower_by_erosion<Adjacency::four>(frame, f.data(), g.data())
                               : lower_by_erosion<Adjacency::eight>(frame, f.data(), g.data());
}

}  // namespace ilot
