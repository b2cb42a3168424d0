// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/plane_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>

#include "kernels/core/parallel.h"

namespace ilot {
namespace {

struct Entry {
  std::uint64_t code;
  std::uint32_t index;
};

constexpr std::size_t kOrderChunk = std::size_t{1} << 16;  // points a task
constexpr int kTopBits = 11, kBits = 8;
constexpr std::size_t kSmall = 24;
// Measured: above it the buckets of the top digit pay for themselves; faces of buildings have a dozen points.
constexpr std::size_t kFewPoints = 512;

constexpr std::uint64_t spread2(std::uint64_t v) {
  v = (v | v << 16) & 0x0000ffff0000ffffull;
  v = (v | v << 8) & 0x00ff00ff00ff00ffull;
  v = (v | v << 4) & 0x0f0f0f0f0f0f0f0full;
  v = (v | v << 2) & 0x3333333333333333ull;
  return (v | v << 1) & 0x5555555555555555ull;
}

bool before(const Entry& a, const Entry& b) {
  return a.code != b.code ? a.code < b.code : a.index < b.index;
}

void insertion_sort(Entry* e, std::size_t n) {
  for (std::size_t i = 1; i < n; ++i) {
    const Entry moved = e[i];
    std::size_t j = i;
    for (; j > 0 && before(moved, e[j - 1]); --j) e[j] = e[j - 1];
    e[j] = moved;
  }
}

// Sorts e[0, n), whose codes agree above `bits`. Equal codes are already in the order of their indices.
void sort_bucket(Entry* e, Entry* other, std::size_t n, int bits) {
  if (n <= kSmall) return insertion_sort(e, n);
  if (bits == 0) return;
  const int shift = std::max(0, bits - kBits);
  const std::uint64_t mask = (std::uint64_t{1} << (bits - shift)) - 1;
  std::array<std::uint32_t, (1 << kBits) + 1> start{};
  for (std::size_t i = 0; i < n; ++i) ++start[(e[i].code >> shift & mask) + 1];
  for (std::size_t d = 0; d <= mask; ++d) start[d + 1] += start[d];
  auto next = start;
  for (std::size_t i = 0; i < n; ++i) other[next[e[i].code >> shift & mask]++] = e[i];
  std::copy_n(other, n, e);
  for (std::size_t d = 0; d <= mask; ++d) sort_bucket(e + start[d], other + start[d], start[d + 1] - start[d], shift);
}

std::size_t chunks_of(std::size_t n) {
  return (n + kOrderChunk - 1) / kOrderChunk;
}

Point2 smallest_coordinates(std::span<const Point2> points) {
  std::vector<Point2> lows(chunks_of(points.size()), {kMaxPlaneCoordinate, kMaxPlaneCoordinate});
  parallel_for(lows.size(), [&](std::size_t c) {
    Point2 low = lows[c];
    for (const Point2 p : points.subspan(c * kOrderChunk, std::min(kOrderChunk, points.size() - c * kOrderChunk)))
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    lows[c] = low;
  });
  Point2 all = lows[0];
  for (const Point2 p : lows) all = {std::min(all.x, p.x), std::min(all.y, p.y)};
  return all;
}

std::uint64_t code_of(Point2 p, Point2 low) {
  return spread2(static_cast<std::uint32_t>(p.x - low.x)) | spread2(static_cast<std::uint32_t>(p.y - low.y)) << 1;
}

std::unique_ptr<Entry[]> sorted_few(std::span<const Point2> points, Point2 low) {
  std::unique_ptr<Entry[]> entries(new Entry[points.size()]);
  for (std::size_t i = 0; i < points.size(); ++i) entries[i] = {code_of(points[i], low), static_cast<std::uint32_t>(i)};
  if (points.size() <= kSmall)
    insertion_sort(entries.get(), points.size());
  else
    std::sort(entries.get(), entries.get() + points.size(), before);
  return entries;
}

// Sorts all entries. They are scattered by their top digit in chunks, and then each bucket is sorted digit by digit on
// its own.
std::unique_ptr<Entry[]> sorted_entries(std::span<const Point2> points) {
  const std::size_t n = points.size(), chunks = chunks_of(n);
  const Point2 low = smallest_coordinates(points);
  if (n <= kFewPoints) return sorted_few(points, low);
  std::unique_ptr<Entry[]> entries(new Entry[n]), sorted(new Entry[n]);
  std::vector<std::uint64_t> ored(chunks);
  parallel_for(chunks, [&](std::size_t c) {
    std::uint64_t all = 0;  // of the chunk; frequent writes to neighbouring slots would slow the threads
    for (std::size_t i = c * kOrderChunk; i < std::min(n, (c + 1) * kOrderChunk); ++i) {
      entries[i] = {code_of(points[i], low), static_cast<std::uint32_t>(i)};
      all |= entries[i].code;
    }
    ored[c] = all;
  });
  std::uint64_t all = 0;
  for (const std::uint64_t v : ored) all |= v;
  const int shift = std::max(0, static_cast<int>(std::bit_width(all)) - kTopBits);
  constexpr std::size_t kDigits = std::size_t{1} << kTopBits;
  std::vector<std::uint32_t> next(chunks * kDigits), start(kDigits + 1);
  parallel_for(chunks, [&](std::size_t c) {
    for (std::size_t i = c * kOrderChunk; i < std::min(n, (c + 1) * kOrderChunk); ++i)
      ++next[c * kDigits + (entries[i].code >> shift)];
  });
  std::uint32_t sum = 0;
  for (std::size_t d = 0; d < kDigits; ++d) {
    start[d] = sum;
    for (std::size_t c = 0; c < chunks; ++c) sum += std::exchange(next[c * kDigits + d], sum);
  }
  start[kDigits] = sum;
  parallel_for(chunks, [&](std::size_t c) {
    for (std::size_t i = c * kOrderChunk; i < std::min(n, (c + 1) * kOrderChunk); ++i)
      sorted[next[c * kDigits + (entries[i].code >> shift)]++] = entries[i];
  });
  parallel_for(kDigits / 16, [&](std::size_t group) {
    for (std::size_t d = group * 16; d < group * 16 + 16; ++d)
      sort_bucket(&sorted[start[d]], &entries[start[d]], start[d + 1] - start[d], shift);
  });
  return sorted;
}

}  // namespace

PlaneOrder plane_order(std::span<const Point2> points) {
  PlaneOrder out;
  if (points.empty()) return out;
  const std::size_t n = points.size(), chunks = chunks_of(n);
  const std::unique_ptr<Entry[]> sorted = sorted_entries(points);
  const auto repeated = [&](std::size_t i) { return i > 0 && sorted[i].code == sorted[i - 1].code; };
  std::vector<std::size_t> first(chunks + 1);
  parallel_for(chunks, [&](std::size_t c) {
    std::size_t count = 0;
    for (std::size_t i = c * kOrderChunk; i < std::min(n, (c + 1) * kOrderChunk); ++i) count += !repeated(i);
    first[c + 1] = count;
  });
  for (std::size_t c = 0; c < chunks; ++c) first[c + 1] += first[c];
  out.points.resize(first[chunks]);
  out.codes.resize(first[chunks]);
  out.index.resize(first[chunks]);
  parallel_for(chunks, [&](std::size_t c) {
    std::size_t to = first[c];
    for (std::size_t i = c * kOrderChunk; i < std::min(n, (c + 1) * kOrderChunk); ++i) {
      if (repeated(i)) continue;
      out.points[to] = points[sorted[i].index];
      out.codes[to] = sorted[i].code;
      out.index[to++] = sorted[i].index;
    }
  });
  if (first[chunks] == n) return out;
  for (std::size_t i = 0, kept = 0; i < n; ++i)
    if (!repeated(i))
      kept = i;
    else
      out.duplicates.emplace_back(sorted[i].index, sorted[kept].index);
  return out;
}

PlaneOrder selected(const PlaneOrder& order, std::span<const std::uint8_t> flags) {
  PlaneOrder out;
  for (std::size_t i = 0; i < order.points.size(); ++i) {
    if (!flags[i]) continue;
    out.points.push_back(order.points[i]);
    out.codes.push_back(order.codes[i]);
    out.index.push_back(order.index[i]);
  }
  return out;
}

}  // namespace ilot
