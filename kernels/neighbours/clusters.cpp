// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/clusters.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "kernels/core/radix_sort.h"
#include "kernels/core/union_find.h"
#include "kernels/neighbours/morton.h"

namespace ilot {
namespace {

struct Bin {
  std::uint32_t x;  // of its cell
  std::uint32_t begin, end;
};

// Bins with the same y and z, ascending by x.
struct Row {
  std::uint64_t key;  // packed y and z of their cells
  std::uint32_t begin, end;
};

struct Binned {
  std::vector<std::uint32_t> members;  // positions in the caller's index list, bin by bin
  std::vector<Bin> bins;               // row by row
  std::vector<Row> rows;               // ascending by key
};

constexpr int kCellBits = 21;

constexpr std::uint64_t pack(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return z << 2 * kCellBits | y << kCellBits | x;
}

// The largest cell of which any two integer points lie within the radius: 3 (edge - 1)^2 <= radius^2.
std::int64_t bin_edge(std::int64_t radius) {
  std::int64_t edge = static_cast<std::int64_t>(static_cast<double>(radius) / 1.7320508075688772) + 2;
  while (edge > 1 && 3 * (edge - 1) * (edge - 1) > radius * radius) --edge;
  return edge;
}

struct IntPoint {
  std::int32_t x, y, z;
};

IntPoint point_at(const Points& p, std::uint32_t i) {
  return {static_cast<std::int32_t>(p.x[i]), static_cast<std::int32_t>(p.y[i]), static_cast<std::int32_t>(p.z[i])};
}

Binned bin_points(const Points& p, std::span<const std::uint32_t> indices, std::int64_t edge) {
  IntPoint low{INT32_MAX, INT32_MAX, INT32_MAX};
  for (const std::uint32_t i : indices) {
    const IntPoint q = point_at(p, i);
    low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
  }
  // Two empty cells below the lowest point, so that neighbours of any cell have keys.
  constexpr std::uint64_t kBorder = 2;
  const auto cell = [&](std::int32_t v, std::int32_t from) {
    return static_cast<std::uint64_t>((std::int64_t{v} - from) / edge) + kBorder;
  };
  std::vector<KeyValue> keys(indices.size()), scratch(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const IntPoint q = point_at(p, indices[i]);
    keys[i] = {pack(cell(q.x, low.x), cell(q.y, low.y), cell(q.z, low.z)), i};
  }
  sort_pairs(keys, scratch);
  Binned binned;
  binned.members.reserve(keys.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    const std::uint64_t key = keys[i].key, row = key >> kCellBits;
    const bool new_row = binned.rows.empty() || binned.rows.back().key != row;
    const auto bin = static_cast<std::uint32_t>(binned.bins.size());
    if (new_row) binned.rows.push_back({row, bin, bin});
    if (new_row || key != keys[i - 1].key) {
      binned.bins.push_back({static_cast<std::uint32_t>(key & ((1u << kCellBits) - 1)), i, i});
      ++binned.rows.back().end;
    }
    ++binned.bins.back().end;
    binned.members.push_back(static_cast<std::uint32_t>(keys[i].value));
  }
  return binned;
}

// The points bin by bin, so that a bin's lie side by side.
std::vector<IntPoint> in_bin_order(const Points& p, std::span<const std::uint32_t> indices, const Binned& binned) {
  std::vector<IntPoint> points(binned.members.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = point_at(p, indices[binned.members[i]]);
  return points;
}

bool within_reach(std::span<const IntPoint> a, std::span<const IntPoint> b, std::int64_t radius2) {
  for (const IntPoint& u : a) {
    for (const IntPoint& v : b) {
      const std::int64_t dx = std::int64_t{u.x} - v.x, dy = std::int64_t{u.y} - v.y, dz = std::int64_t{u.z} - v.z;
      if (dx * dx + dy * dy + dz * dz <= radius2) return true;
    }
  }
  return false;
}

// Rows ahead of a row in key order that its points can reach, and how many cells along x.
struct Ahead {
  std::uint64_t delta;  // of the keys
  std::uint32_t reach;
};

// Up to `most` cells away along any axis; the row itself first.
std::vector<Ahead> rows_ahead(std::int64_t edge, std::int64_t radius, int most) {
  const auto gap2 = [&](int d) {
    const std::int64_t gap = d == 0 ? 0 : (std::abs(d) - 1) * edge + 1;
    return gap * gap;
  };
  std::vector<Ahead> ahead;
  for (int dz = 0; dz <= most; ++dz)
    for (int dy = dz == 0 ? 0 : -most; dy <= most; ++dy) {
      int reach = most;
      while (reach >= 0 && gap2(reach) + gap2(dy) + gap2(dz) > radius * radius) --reach;
      const std::int64_t delta = std::int64_t{dz} * (1 << kCellBits) + dy;
      if (reach >= 0) ahead.push_back({static_cast<std::uint64_t>(delta), static_cast<std::uint32_t>(reach)});
    }
  return ahead;
}

// Joins each bin of row a with those of row b at most `reach` cells along x from it that have a point within the
// radius.
void join_rows(const Binned& binned, std::span<const IntPoint> points, const Row& a, const Row& b, std::uint32_t reach,
               std::int64_t radius2, UnionFind& sets) {
  const auto& bins = binned.bins;
  const auto members = [&](std::uint32_t i) { return points.subspan(bins[i].begin, bins[i].end - bins[i].begin); };
  std::uint32_t first = b.begin;
  for (std::uint32_t i = a.begin; i < a.end; ++i) {
    while (first < b.end && bins[first].x + reach < bins[i].x) ++first;
    for (std::uint32_t k = a.begin == b.begin ? i + 1 : first; k < b.end && bins[k].x <= bins[i].x + reach; ++k)
      if (!sets.same(i, k) && within_reach(members(i), members(k), radius2)) sets.unite(i, k);
  }
}

// Rows ascend, so the row that is some way ahead only moves ahead.
void join_ahead(const Binned& binned, std::span<const IntPoint> points, const std::vector<Ahead>& ahead,
                std::int64_t radius2, UnionFind& sets) {
  const auto& rows = binned.rows;
  std::vector<std::size_t> at(ahead.size(), 0);
  for (const Row& row : rows) {
    for (std::size_t r = 0; r < ahead.size(); ++r) {
      std::size_t& j = at[r];
      while (j < rows.size() && rows[j].key < row.key + ahead[r].delta) ++j;
      if (j < rows.size() && rows[j].key == row.key + ahead[r].delta)
        join_rows(binned, points, row, rows[j], ahead[r].reach, radius2, sets);
    }
  }
}

// Neighbouring cells first: they join most, and bins of one set need no measuring.
void join_bins(const Binned& binned, std::span<const IntPoint> points, std::int64_t edge, std::int64_t radius,
               UnionFind& sets) {
  for (const int most : {1, 2}) {
    join_ahead(binned, points, rows_ahead(edge, radius, most), radius * radius, sets);
    sets.flatten();
  }
}

}  // namespace

Clusters euclidean_clusters(Points points, std::span<const std::uint32_t> indices, std::int64_t radius) {
  assert(radius >= 1);
  if (indices.empty()) return {};
  const std::int64_t edge = bin_edge(radius);
  const Binned binned = bin_points(points, indices, edge);
  std::vector<std::uint32_t> parents(binned.bins.size());
  UnionFind sets(parents);
  join_bins(binned, in_bin_order(points, indices, binned), edge, radius, sets);

  std::vector<std::uint32_t> root_of(indices.size());
  for (std::uint32_t b = 0; b < binned.bins.size(); ++b) {
    const std::uint32_t root = sets.find(b);
    for (std::uint32_t i = binned.bins[b].begin; i < binned.bins[b].end; ++i) root_of[binned.members[i]] = root;
  }
  Clusters clusters{std::vector<std::uint32_t>(indices.size()), 0};
  constexpr std::uint32_t kUnnumbered = 0xffffffffu;
  std::vector<std::uint32_t> number(binned.bins.size(), kUnnumbered);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t& n = number[root_of[i]];
    if (n == kUnnumbered) n = clusters.count++;
    clusters.id[i] = n;
  }
  return clusters;
}

}  // namespace ilot
