// SPDX-License-Identifier: Apache-2.0
// Points with integer coordinates in bins, and whether two bins have points within a radius of each other.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/radix_sort.h"
#include "kernels/core/types.h"
#include "kernels/geometry/box3.h"

namespace ilot {

struct IntPoint {
  std::int32_t x, y, z;
};

inline IntPoint point_at(const Points& p, std::uint32_t i) {
  return {static_cast<std::int32_t>(p.x[i]), static_cast<std::int32_t>(p.y[i]), static_cast<std::int32_t>(p.z[i])};
}

// Returns the edge of the largest bin in which any two integer points are within the radius: 3 (edge - 1)^2 <=
// radius^2.
std::int64_t bin_edge(std::int64_t radius);

using IntBox = Box3<IntPoint>;

inline IntBox box_of(std::span<const IntPoint> points) {
  IntBox b{points.front(), points.front()};
  for (const IntPoint& p : points) b.add(p);
  return b;
}

inline bool within_reach(const IntPoint& a, const IntPoint& b, std::int64_t radius2) {
  const std::int64_t x = std::int64_t{a.x} - b.x, y = std::int64_t{a.y} - b.y, z = std::int64_t{a.z} - b.z;
  return x * x + y * y + z * z <= radius2;
}

// Whether any point of the first set is within the radius of any of the second.
bool within_reach(std::span<const IntPoint> a, std::span<const IntPoint> b, std::int64_t radius2);

// The same where the box of each set is known.
bool within_reach(std::span<const IntPoint> a, const IntBox& box_a, std::span<const IntPoint> b, const IntBox& box_b,
                  std::int64_t radius2);

// The key of a bin has 21 bits for its number along each axis. The lowest number in use is kBinBorder, so that the
// neighbours of any bin have keys.
constexpr int kBinBits = 21;
constexpr std::uint64_t kBinBorder = 2;
constexpr std::uint64_t pack_bin(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return z << 2 * kBinBits | y << kBinBits | x;
}

// From coordinates along an axis to numbers of bins of that edge, from kBinBorder at `from` on.
struct BinAxis {
  std::int32_t from = 0;
  double per_unit = 1;

  // Half a unit more keeps the quotient 2^-26 away from integers, which is more than the error of the product of
  // doubles.
  std::uint64_t operator()(std::int32_t v) const {
    return static_cast<std::uint64_t>((static_cast<double>(v) - from + 0.5) * per_unit) + kBinBorder;
  }
};

constexpr int kMostBinsAway = 2;  // greatest distance in bins between points in reach of each other, along any axis

// Runs of consecutive points of one bin, by its key and then by their first point, which is the value. Consecutive
// points are mostly in one bin, so there are fewer runs to sort than points.
struct BinRuns {
  std::vector<KeyValue> runs;
  std::vector<std::uint32_t> length;  // by first point; 0 for the others
};

template <class KeyOf>
BinRuns sorted_runs(std::size_t points, const KeyOf& key_of) {
  BinRuns out{{}, std::vector<std::uint32_t>(points, 0)};
  for (std::uint32_t i = 0; i < points; ++i) {
    const std::uint64_t key = key_of(i);
    if (out.runs.empty() || out.runs.back().key != key) out.runs.push_back({key, i});
    ++out.length[out.runs.back().value];
  }
  std::vector<KeyValue> scratch(out.runs.size());
  sort_pairs(out.runs, scratch);
  return out;
}

// Rows of bins with one z that the points of a row can reach: the row itself and those behind it in key order.
struct RowsAhead {
  std::uint64_t first = 0;  // added to the key of the row to get the first of them
  std::vector<int> along;   // for each y from there: bins along x; below 0: none
};

// Returns the rows up to `most` bins away along any axis. The row itself comes first.
std::vector<RowsAhead> rows_ahead(std::int64_t edge, std::int64_t radius, int most);

}  // namespace ilot
