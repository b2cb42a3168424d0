// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/clusters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "kernels/core/union_find.h"
#include "kernels/neighbours/reach.h"

namespace ilot {
namespace {

// Bins that follow each other along the longest axis of the points. Here this axis is called x, whichever it is: what
// is in reach does not depend on the names of the axes, and few long rows are joined faster than many short ones.
struct Row {
  std::uint64_t key;         // packed y and z of its bins
  std::uint32_t begin, end;  // bins
};

struct Binned {
  std::vector<std::uint32_t> members;  // positions in the caller's index list, bin by bin
  std::vector<std::uint32_t> x;        // of each bin, row by row
  std::vector<std::uint32_t> begin;    // of each bin's members; one more than there are bins
  std::vector<Row> rows;               // ascending by key
};

constexpr std::size_t kFew = 96;

// The axis along which the points reach farthest: 0, 1 or 2.
int longest_axis(const IntPoint& low, const IntPoint& high) {
  const std::int64_t x = std::int64_t{high.x} - low.x, y = std::int64_t{high.y} - low.y,
                     z = std::int64_t{high.z} - low.z;
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

Binned bin_points(const Points& p, std::span<const std::uint32_t> indices, std::int64_t edge) {
  IntPoint low{INT32_MAX, INT32_MAX, INT32_MAX}, high{INT32_MIN, INT32_MIN, INT32_MIN};
  for (const std::uint32_t i : indices) {
    const IntPoint q = point_at(p, i);
    low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z)};
  }
  const int axis = longest_axis(low, high);
  const double per_unit = 1 / static_cast<double>(edge);
  const BinAxis in_x{low.x, per_unit}, in_y{low.y, per_unit}, in_z{low.z, per_unit};
  const auto [runs, length] = sorted_runs(indices.size(), [&](std::uint32_t i) {
    const IntPoint q = point_at(p, indices[i]);
    const std::uint64_t x = in_x(q.x), y = in_y(q.y), z = in_z(q.z);
    return axis == 0 ? pack_bin(x, y, z) : axis == 1 ? pack_bin(y, x, z) : pack_bin(z, x, y);
  });
  Binned binned;
  binned.members.reserve(indices.size());
  for (auto* v : {&binned.x, &binned.begin}) v->reserve(runs.size() + 1);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::uint64_t key = runs[i].key, row = key >> kBinBits;
    const bool new_row = binned.rows.empty() || binned.rows.back().key != row;
    const auto bin = static_cast<std::uint32_t>(binned.x.size());
    if (new_row) binned.rows.push_back({row, bin, bin});
    if (new_row || key != runs[i - 1].key) {
      binned.x.push_back(static_cast<std::uint32_t>(key & ((1u << kBinBits) - 1)));
      binned.begin.push_back(static_cast<std::uint32_t>(binned.members.size()));
      ++binned.rows.back().end;
    }
    const auto first = static_cast<std::uint32_t>(runs[i].value);
    for (std::uint32_t k = 0; k < length[first]; ++k) binned.members.push_back(first + k);
  }
  binned.begin.push_back(static_cast<std::uint32_t>(binned.members.size()));
  return binned;
}

// Returns the points bin by bin, so that the points of a bin are stored side by side.
std::vector<IntPoint> in_bin_order(const Points& p, std::span<const std::uint32_t> indices, const Binned& binned) {
  std::vector<IntPoint> points(binned.members.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = point_at(p, indices[binned.members[i]]);
  return points;
}

// Consecutive bins of a row, each of which reaches the next. They are one set from the start.
struct Segment {
  std::uint32_t first_x, last_x;
  std::uint32_t begin, end;  // bins
};

struct Segments {
  std::vector<Segment> all;          // row by row
  std::vector<std::uint32_t> begin;  // of each row; one more than there are rows
};

class Joiner {
 public:
  Joiner(const Binned& binned, std::span<const IntPoint> points, std::int64_t radius2)
      : binned_(binned), points_(points), radius2_(radius2) {}

  Segments segments() const {
    Segments s{{}, {0}};
    for (const Row& row : binned_.rows) {
      for (std::uint32_t i = row.begin; i < row.end; ++i) {
        const std::uint32_t x = binned_.x[i];
        const bool goes_on = i > row.begin && x - binned_.x[i - 1] <= 2 && reach(i - 1, i);
        if (!goes_on) s.all.push_back({x, x, i, i});
        s.all.back().last_x = x;
        s.all.back().end = i + 1;
      }
      s.begin.push_back(static_cast<std::uint32_t>(s.all.size()));
    }
    return s;
  }

  // Joins the segments of two rows (or of one) that are at most `along` bins apart along x and have points in reach.
  // Returns by how many the number of sets falls.
  std::uint32_t join_rows(const Segments& s, std::size_t row, std::size_t other, std::uint32_t along,
                          UnionFind sets) const {
    std::uint32_t first = s.begin[other], joins = 0;
    for (std::uint32_t i = s.begin[row]; i < s.begin[row + 1]; ++i) {
      const Segment& a = s.all[i];
      while (first < s.begin[other + 1] && s.all[first].last_x + along < a.first_x) ++first;
      for (std::uint32_t k = row == other ? i + 1 : first; k < s.begin[other + 1]; ++k) {
        if (s.all[k].first_x > a.last_x + along) break;
        if (!sets.same(i, k) && meet(a, s.all[k], along)) joins += sets.unite(i, k);
      }
    }
    return joins;
  }

 private:
  std::span<const IntPoint> members(std::uint32_t bin) const {
    return points_.subspan(binned_.begin[bin], binned_.begin[bin + 1] - binned_.begin[bin]);
  }
  bool reach(std::uint32_t i, std::uint32_t k) const { return within_reach(members(i), members(k), radius2_); }

  bool meet(const Segment& a, const Segment& b, std::uint32_t along) const {
    const std::uint32_t* x = binned_.x.data();
    std::uint32_t first = b.begin;
    const std::uint32_t low = b.first_x > along ? b.first_x - along : 0;
    for (auto i = static_cast<std::uint32_t>(std::lower_bound(x + a.begin, x + a.end, low) - x); i < a.end; ++i) {
      while (first < b.end && x[first] + along < x[i]) ++first;
      if (first == b.end) return false;
      for (std::uint32_t k = first; k < b.end && x[k] <= x[i] + along; ++k)
        if (reach(i, k)) return true;
    }
    return false;
  }

  const Binned& binned_;
  std::span<const IntPoint> points_;
  std::int64_t radius2_;
};

// Rows are in ascending order, so the first row at a given distance ahead only moves forward. `count` is the number of
// sets. The function may stop at one.
void join_ahead(const Joiner& joiner, const Segments& segments, const std::vector<Row>& rows,
                const std::vector<RowsAhead>& ahead, UnionFind sets, std::size_t& count) {
  std::array<std::size_t, kMostBinsAway + 1> at{};
  for (std::size_t i = 0; i < rows.size() && count > 1; ++i) {
    for (std::size_t r = 0; r < ahead.size(); ++r) {
      std::size_t& first = at[r];
      const std::uint64_t wanted = rows[i].key + ahead[r].first;
      while (first < rows.size() && rows[first].key < wanted) ++first;
      for (std::size_t j = first; j < rows.size() && rows[j].key - wanted < ahead[r].along.size(); ++j)
        if (const int along = ahead[r].along[rows[j].key - wanted]; along >= 0)
          count -= joiner.join_rows(segments, i, j, static_cast<std::uint32_t>(along), sets);
    }
  }
}

// Grows clusters from one point after the other, which is cheaper than bins for few points.
Clusters clusters_of_few(const Points& p, std::span<const std::uint32_t> indices, std::int64_t radius2) {
  struct Member {
    IntPoint at;
    std::uint32_t place;  // in the caller's list
  };
  std::array<Member, kFew> members;
  for (std::uint32_t i = 0; i < indices.size(); ++i) members[i] = {point_at(p, indices[i]), i};
  Clusters clusters{std::vector<std::uint32_t>(indices.size()), 0};
  std::size_t begin = 0, reached = 0;  // members up to `begin` are done, those up to `reached` are in a cluster
  const std::size_t end = indices.size();
  while (begin < end) {
    if (begin == reached) {  // a cluster ends, and the next one starts with the first of the remaining members
      const auto first = std::min_element(members.begin() + static_cast<std::ptrdiff_t>(begin),
                                          members.begin() + static_cast<std::ptrdiff_t>(end),
                                          [](const Member& a, const Member& b) { return a.place < b.place; });
      std::swap(*first, members[reached++]);
      ++clusters.count;
    }
    const Member from = members[begin++];
    clusters.id[from.place] = clusters.count - 1;
    for (std::size_t i = reached; i < end; ++i)
      if (within_reach(from.at, members[i].at, radius2)) std::swap(members[i], members[reached++]);
  }
  return clusters;
}

}  // namespace

Clusters euclidean_clusters(Points points, std::span<const std::uint32_t> indices, std::int64_t radius) {
  assert(radius >= 1);
  if (indices.size() <= kFew) return clusters_of_few(points, indices, radius * radius);
  const std::int64_t edge = bin_edge(radius);
  const Binned binned = bin_points(points, indices, edge);
  const std::vector<IntPoint> in_bins = in_bin_order(points, indices, binned);
  const Joiner joiner(binned, in_bins, radius * radius);
  const Segments segments = joiner.segments();
  std::vector<std::uint32_t> parents(segments.all.size());
  UnionFind sets(parents);
  std::size_t count = segments.all.size();
  // Neighbouring rows come first, because they join most sets, and points of one set need no measuring.
  for (const int most : {1, kMostBinsAway})
    join_ahead(joiner, segments, binned.rows, rows_ahead(edge, radius, most), sets, count);

  std::vector<std::uint32_t> root_of(indices.size());
  for (std::uint32_t s = 0; s < segments.all.size(); ++s) {
    const std::uint32_t root = sets.find(s);
    for (std::uint32_t i = binned.begin[segments.all[s].begin]; i < binned.begin[segments.all[s].end]; ++i)
      root_of[binned.members[i]] = root;
  }
  Clusters clusters{std::vector<std::uint32_t>(indices.size()), 0};
  constexpr std::uint32_t kUnnumbered = 0xffffffffu;
  std::vector<std::uint32_t> number(parents.size(), kUnnumbered);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t& n = number[root_of[i]];
    if (n == kUnnumbered) n = clusters.count++;
    clusters.id[i] = n;
  }
  return clusters;
}

}  // namespace ilot
