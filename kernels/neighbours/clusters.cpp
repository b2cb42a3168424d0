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
  std::uint64_t key;  // packed cell coordinates, 21 bits each
  std::uint32_t begin, end;
};

struct Binned {
  std::vector<std::uint32_t> members;  // positions in the caller's index list, bin by bin
  std::vector<Bin> bins;               // ascending by key
};

constexpr std::uint64_t pack(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return z << 42 | y << 21 | x;
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
  std::vector<std::uint64_t> keys(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const IntPoint q = point_at(p, indices[i]);
    keys[i] = pack(cell(q.x, low.x), cell(q.y, low.y), cell(q.z, low.z));
  }
  Binned binned{sorted_order(keys), {}};
  for (std::size_t i = 0; i < binned.members.size(); ++i) {
    const std::uint64_t key = keys[binned.members[i]];
    if (binned.bins.empty() || binned.bins.back().key != key)
      binned.bins.push_back({key, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)});
    ++binned.bins.back().end;
  }
  return binned;
}

bool within_reach(const Points& p, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
                  std::span<const std::uint32_t> indices, std::int64_t radius2) {
  for (const std::uint32_t i : a) {
    const IntPoint u = point_at(p, indices[i]);
    for (const std::uint32_t j : b) {
      const IntPoint v = point_at(p, indices[j]);
      const std::int64_t dx = std::int64_t{u.x} - v.x, dy = std::int64_t{u.y} - v.y, dz = std::int64_t{u.z} - v.z;
      if (dx * dx + dy * dy + dz * dz <= radius2) return true;
    }
  }
  return false;
}

// Cell offsets ahead of a cell in key order that its points can reach, nearest first so that most joins happen early.
std::vector<std::int64_t> forward_offsets(std::int64_t edge, std::int64_t radius) {
  struct Offset {
    std::int64_t gap2, delta;
  };
  std::vector<Offset> offsets;
  const auto gap = [&](int d) { return d == 0 ? std::int64_t{0} : (std::abs(d) - 1) * edge + 1; };
  for (int dz = -2; dz <= 2; ++dz)
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const std::int64_t delta = (std::int64_t{dz} * (1 << 21) + dy) * (1 << 21) + dx;
        const std::int64_t gap2 = gap(dx) * gap(dx) + gap(dy) * gap(dy) + gap(dz) * gap(dz);
        if (delta > 0 && gap2 <= radius * radius) offsets.push_back({gap2, delta});
      }
  std::sort(offsets.begin(), offsets.end(),
            [](const Offset& a, const Offset& b) { return a.gap2 != b.gap2 ? a.gap2 < b.gap2 : a.delta < b.delta; });
  std::vector<std::int64_t> deltas;
  for (const Offset& o : offsets) deltas.push_back(o.delta);
  return deltas;
}

void join_bins(const Points& p, std::span<const std::uint32_t> indices, const Binned& binned, std::int64_t edge,
               std::int64_t radius, UnionFind& sets) {
  const auto& bins = binned.bins;
  const auto members = [&](const Bin& b) { return std::span(binned.members).subspan(b.begin, b.end - b.begin); };
  for (const std::int64_t delta : forward_offsets(edge, radius)) {
    // Both sides ascend, so one sweep finds every pair of bins `delta` apart.
    std::size_t j = 0;
    for (std::uint32_t i = 0; i < bins.size(); ++i) {
      const std::uint64_t wanted = bins[i].key + static_cast<std::uint64_t>(delta);
      while (j < bins.size() && bins[j].key < wanted) ++j;
      if (j == bins.size()) break;
      const auto other = static_cast<std::uint32_t>(j);
      if (bins[j].key != wanted || sets.find(i) == sets.find(other)) continue;
      if (within_reach(p, members(bins[i]), members(bins[j]), indices, radius * radius)) sets.unite(i, other);
    }
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
  join_bins(points, indices, binned, edge, radius, sets);

  std::vector<std::uint32_t> bin_of(indices.size());
  for (std::uint32_t b = 0; b < binned.bins.size(); ++b)
    for (std::uint32_t i = binned.bins[b].begin; i < binned.bins[b].end; ++i) bin_of[binned.members[i]] = b;
  Clusters clusters{std::vector<std::uint32_t>(indices.size()), 0};
  constexpr std::uint32_t kUnnumbered = 0xffffffffu;
  std::vector<std::uint32_t> number(binned.bins.size(), kUnnumbered);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t& n = number[sets.find(bin_of[i])];
    if (n == kUnnumbered) n = clusters.count++;
    clusters.id[i] = n;
  }
  return clusters;
}

}  // namespace ilot
