// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/cluster_grid.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

struct Bin {
  std::uint64_t key;
  std::uint32_t number;
};

IntBox box_of_all(Points p) {
  auto box = IntBox::none();
  for (std::uint32_t i = 0; i < p.size; ++i) box.add(point_at(p, i));
  return box;
}

bool fits(const IntBox& box, std::int64_t edge) {
  const std::int64_t longest = std::max(
      {std::int64_t{box.max.x} - box.min.x, std::int64_t{box.max.y} - box.min.y, std::int64_t{box.max.z} - box.min.z});
  constexpr std::int64_t kBorders = 2 * (static_cast<std::int64_t>(kBinBorder) + 1);
  return longest / edge + kBorders < std::int64_t{1} << kBinBits;
}

// Numbers the bins by their first point. Returns them by key.
std::vector<Bin> number_bins(Points p, const IntBox& box, std::int64_t edge, std::vector<std::uint32_t>& bin_of) {
  const double per_unit = 1 / static_cast<double>(edge);
  const BinAxis in_x{box.min.x, per_unit}, in_y{box.min.y, per_unit}, in_z{box.min.z, per_unit};
  const BinRuns sorted = sorted_runs(p.size, [&](std::uint32_t i) {
    const IntPoint q = point_at(p, i);
    return pack_bin(in_x(q.x), in_y(q.y), in_z(q.z));
  });
  std::vector<Bin> bins;
  bin_of.resize(p.size);  // at first the places of the bins in key order
  for (const KeyValue& run : sorted.runs) {
    if (bins.empty() || bins.back().key != run.key) bins.push_back({run.key, kNone});
    std::fill_n(bin_of.begin() + static_cast<std::ptrdiff_t>(run.value), sorted.length[run.value],
                static_cast<std::uint32_t>(bins.size() - 1));
  }
  std::uint32_t count = 0;
  for (std::uint32_t& of : bin_of) {
    Bin& b = bins[of];
    if (b.number == kNone) b.number = count++;
    of = b.number;
  }
  return bins;
}

// Adds the bins ahead of each bin in key order. For each distance in y and z the first bin in reach only moves forward.
// Returns false, with some of them only, where they are too many for so few points.
bool add_near(ClusterGrid& grid, const std::vector<Bin>& bins, std::int64_t edge) {
  // A bin can have 58 bins ahead. Where several points are in a bin, as on facades, few of them are listed for a point.
  constexpr std::size_t kMostNear = 8;  // for each point
  struct Row {
    std::uint64_t first, last;  // added to the key of a bin: the range of the keys in reach
    bool touching;
    std::size_t at;
  };
  std::vector<Row> rows;
  const std::vector<RowsAhead> ahead = rows_ahead(edge, grid.radius, kMostBinsAway);
  for (std::size_t dz = 0; dz < ahead.size(); ++dz)
    for (std::size_t k = 0; k < ahead[dz].along.size(); ++k) {
      const int along = ahead[dz].along[k], dy = static_cast<int>(k) - (dz == 0 ? 0 : kMostBinsAway);
      if (along < 0) continue;
      const std::uint64_t row = (ahead[dz].first + k) << kBinBits;
      const std::uint64_t first = dz == 0 && dy == 0 ? row + 1 : row - static_cast<std::uint64_t>(along);
      rows.push_back({first, row + static_cast<std::uint64_t>(along), dz <= 1 && std::abs(dy) <= 1, 0});
    }
  grid.near_of.resize(bins.size());
  std::vector<std::uint32_t> farther;
  for (const Bin& b : bins) {
    ClusterGrid::Near& near = grid.near_of[b.number];
    near.begin = grid.near.size();
    farther.clear();
    for (Row& row : rows) {
      while (row.at < bins.size() && bins[row.at].key < b.key + row.first) ++row.at;
      for (std::size_t j = row.at; j < bins.size() && bins[j].key <= b.key + row.last; ++j) {
        const auto dx = static_cast<std::int64_t>(bins[j].key & ((1u << kBinBits) - 1)) -
                        static_cast<std::int64_t>(b.key & ((1u << kBinBits) - 1));
        const bool touching = row.touching && std::abs(dx) <= 1;
        (touching ? grid.near : farther).push_back(bins[j].number);
      }
    }
    near.touching = static_cast<std::uint32_t>(grid.near.size() - near.begin);
    grid.near.insert(grid.near.end(), farther.begin(), farther.end());
    near.all = static_cast<std::uint32_t>(grid.near.size() - near.begin);
    if (grid.near.size() > kMostNear * grid.bin.size()) return false;
  }
  return true;
}

// Sorts the points into the bins in use.
void fill_bins(const ClusterGrid& grid, Points points, std::span<const std::uint32_t> indices, ClusterScratch& s) {
  if (s.slot.size() < grid.near_of.size()) s.slot.resize(grid.near_of.size(), kNone);
  s.bins.clear();
  s.begin.clear();
  s.of.resize(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t& slot = s.slot[grid.bin[indices[i]]];
    if (slot == kNone) {
      slot = static_cast<std::uint32_t>(s.bins.size());
      s.bins.push_back(grid.bin[indices[i]]);
      s.begin.push_back(0);
    }
    ++s.begin[slot];
    s.of[i] = slot;
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& b : s.begin) sum += b, b = sum;  // ends, which the loop below turns into beginnings
  s.begin.push_back(sum);
  s.points.resize(indices.size());
  for (std::size_t i = indices.size(); i-- > 0;) s.points[--s.begin[s.of[i]]] = point_at(points, indices[i]);
}

bool in_reach(std::span<const IntPoint> a, std::span<const IntPoint> b, std::int64_t radius2) {
  constexpr std::size_t kFewPairs = 64;  // fewer cost less than their boxes
  if (a.size() * b.size() <= kFewPairs) return within_reach(a, b, radius2);
  return within_reach(a, box_of(a), b, box_of(b), radius2);
}

// Joins bins in use that have points in reach of each other. Bins that touch come first, because they join most sets,
// and bins of one set need no measuring. Those in use are picked without branches, which would be mispredicted.
void join_bins(const ClusterGrid& grid, ClusterScratch& s, UnionFind sets) {
  const auto points_of = [&](std::uint32_t slot) {
    return std::span(s.points).subspan(s.begin[slot], s.begin[slot + 1] - s.begin[slot]);
  };
  const std::int64_t radius2 = grid.radius * grid.radius;
  std::size_t count = s.bins.size();
  for (const bool touching : {true, false})
    for (std::uint32_t a = 0; a < s.bins.size() && count > 1; ++a) {
      const ClusterGrid::Near& near = grid.near_of[s.bins[a]];
      const auto all = std::span(grid.near).subspan(near.begin, near.all);
      if (s.met.size() < near.all) s.met.resize(near.all);
      std::size_t met = 0;
      for (const std::uint32_t bin : touching ? all.first(near.touching) : all.subspan(near.touching)) {
        s.met[met] = s.slot[bin];
        met += s.met[met] != kNone;
      }
      for (const std::uint32_t b : std::span(s.met).first(met))
        if (!sets.same(a, b) && in_reach(points_of(a), points_of(b), radius2)) count -= sets.unite(a, b);
    }
}

}  // namespace

ClusterGrid build_cluster_grid(Points points, std::int64_t radius) {
  assert(radius >= 1);
  ClusterGrid grid;
  if (points.size == 0) return grid;
  const std::int64_t edge = bin_edge(radius);
  const IntBox box = box_of_all(points);
  if (!fits(box, edge)) return grid;
  grid.radius = radius;
  const std::vector<Bin> bins = number_bins(points, box, edge, grid.bin);
  if (!add_near(grid, bins, edge)) return {};
  return grid;
}

ClusterGrid subset_grid(const ClusterGrid& grid, std::span<const std::uint32_t> bins) {
  ClusterGrid out;
  out.radius = grid.radius;
  std::vector<std::uint32_t> number(grid.near_of.size(), kNone), used;
  for (const std::uint32_t bin : bins) {
    if (number[bin] == kNone) {
      number[bin] = static_cast<std::uint32_t>(used.size());
      used.push_back(bin);
    }
    out.bin.push_back(number[bin]);
  }
  for (const std::uint32_t bin : used) {
    const ClusterGrid::Near& from = grid.near_of[bin];
    ClusterGrid::Near& to = out.near_of.emplace_back();
    to.begin = out.near.size();
    for (std::uint32_t k = 0; k < from.all; ++k) {
      const std::uint32_t other = number[grid.near[from.begin + k]];
      if (other == kNone) continue;
      out.near.push_back(other);
      ++to.all;
      to.touching += k < from.touching;
    }
  }
  return out;
}

Clusters grid_clusters(const ClusterGrid& grid, Points points, std::span<const std::uint32_t> indices,
                       ClusterScratch& s) {
  fill_bins(grid, points, indices, s);
  s.parent.resize(s.bins.size());
  UnionFind sets(s.parent);
  join_bins(grid, s, sets);
  for (const std::uint32_t bin : s.bins) s.slot[bin] = kNone;
  Clusters clusters{std::vector<std::uint32_t>(indices.size()), 0};
  s.number.assign(s.bins.size(), kNone);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t& n = s.number[sets.find(s.of[i])];
    if (n == kNone) n = clusters.count++;
    clusters.id[i] = n;
  }
  return clusters;
}

}  // namespace ilot
