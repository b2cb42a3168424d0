// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/split_merge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "kernels/core/radix_sort.h"
#include "kernels/neighbours/morton.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/refine.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::uint32_t kNone = 0xffffffffu;

struct Leaf {
  std::uint64_t code = 0;  // of its corner
  int level = 0;           // edge 2^level
  std::uint32_t begin = 0, end = 0;
  Moments moments;
  PlaneFit fit;
  bool fits = false;  // one plane within the tolerance
  bool sure = false;  // its normal is known within the angle that joins
  std::uint32_t segment = kNone;
};

struct Sorted {
  std::vector<std::uint64_t> code;
  Indices index;  // into the caller's points, in the order of codes
};

Sorted sort_points(Points p) {
  Sorted s;
  if (p.size == 0) return s;
  const float x = *std::min_element(p.x, p.x + p.size), y = *std::min_element(p.y, p.y + p.size),
              z = *std::min_element(p.z, p.z + p.size);
  std::vector<std::uint64_t> codes(p.size);
  for (std::size_t i = 0; i < p.size; ++i)
    codes[i] = morton_code({static_cast<std::uint32_t>(p.x[i] - x), static_cast<std::uint32_t>(p.y[i] - y),
                            static_cast<std::uint32_t>(p.z[i] - z)});
  s.index = sorted_order(codes);
  for (const std::uint32_t i : s.index) s.code.push_back(codes[i]);
  return s;
}

class Octree {
 public:
  Octree(Points points, const SplitMergeParams& params) : points_(points), params_(params), s_(sort_points(points)) {
    if (points.size == 0) return;
    const int top = (static_cast<int>(std::bit_width(s_.code.back())) + 2) / 3;
    split(0, static_cast<std::uint32_t>(points.size), top);
  }

  std::vector<Leaf> leaves;  // ascending by code
  std::span<const std::uint32_t> points_of(const Leaf& l) const {
    return std::span(s_.index).subspan(l.begin, l.end - l.begin);
  }

  // Returns the pairs of leaves that touch, each from the side of the smaller leaf.
  std::vector<Indices> contacts() const {
    std::vector<Indices> beside(leaves.size());
    for (std::uint32_t i = 0; i < leaves.size(); ++i)
      for (int d = 0; d < 27; ++d) {
        const std::uint32_t j = neighbour(leaves[i], d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
        if (j == kNone || j == i) continue;
        beside[i].push_back(j);
        beside[j].push_back(i);
      }
    for (Indices& b : beside) {
      std::sort(b.begin(), b.end());
      b.erase(std::unique(b.begin(), b.end()), b.end());
    }
    return beside;
  }

 private:
  void split(std::uint32_t begin, std::uint32_t end, int level) {
    Leaf leaf{s_.code[begin] >> 3 * level << 3 * level, level, begin, end, {}, {}};
    const std::uint32_t count = end - begin;
    if (count >= params_.min_cell_points) {
      leaf.moments = moments_of(points_, points_of(leaf));
      leaf.fit = fit_plane(leaf.moments);
      leaf.fits = leaf.fit.unique && leaf.fit.rms <= params_.tolerance;
    }
    const bool smallest = level == 0 || (std::int64_t{1} << (level - 1)) < params_.min_edge;
    leaf.sure = leaf.fits && normal_is_sure(leaf);
    if (leaf.fits || count < params_.min_cell_points || smallest) {
      leaves.push_back(leaf);
      return;
    }
    const int shift = 3 * (level - 1);
    for (std::uint32_t from = begin; from < end;) {
      std::uint32_t to = from;
      while (to < end && s_.code[to] >> shift == s_.code[from] >> shift) ++to;
      split(from, to, level - 1);
      from = to;
    }
  }

  // The error of a normal is about noise / (spread along the shorter axis x root of the number of points). The noise is
  // the tolerance, because a single row of points may fit a meaningless plane without any noise.
  bool normal_is_sure(const Leaf& leaf) const {
    const double spread2 = eigen_symmetric(covariance(leaf.moments)).values[1];
    const double sine2 = 1 - params_.min_cos * params_.min_cos;
    return 4 * params_.tolerance * params_.tolerance <= sine2 * spread2 * static_cast<double>(leaf.moments.n);
  }

  // Returns the leaf, at least as large, that covers the cell beside this one.
  std::uint32_t neighbour(const Leaf& leaf, int dx, int dy, int dz) const {
    const Cell3 c = morton_cell(leaf.code);
    const std::int64_t edge = std::int64_t{1} << leaf.level, limit = std::int64_t{1} << kMortonBits;
    const std::int64_t x = c.x + dx * edge, y = c.y + dy * edge, z = c.z + dz * edge;
    if (x < 0 || y < 0 || z < 0 || x >= limit || y >= limit || z >= limit) return kNone;
    const std::uint64_t code =
        morton_code({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)});
    auto at =
        std::upper_bound(leaves.begin(), leaves.end(), code, [](std::uint64_t v, const Leaf& l) { return v < l.code; });
    if (at == leaves.begin()) return kNone;
    --at;
    if (at->level < leaf.level || code >> 3 * at->level != at->code >> 3 * at->level) return kNone;
    return static_cast<std::uint32_t>(at - leaves.begin());
  }

  Points points_;
  SplitMergeParams params_;
  Sorted s_;
};

struct Segment {
  Moments moments;
  Plane plane;
  Indices leaves;
};

bool joins(const Segment& s, const Leaf& leaf, const SplitMergeParams& params) {
  if (std::abs(signed_distance(s.plane, centroid(leaf.moments))) > params.max_step) return false;
  if (!leaf.sure) return rms_to_plane(leaf.moments, s.plane) <= 2 * params.tolerance;
  return std::abs(dot(s.plane.n, leaf.fit.plane.n)) >= params.min_cos;
}

std::vector<Segment> merge(std::vector<Leaf>& leaves, const std::vector<Indices>& beside,
                           const SplitMergeParams& params) {
  Indices order;
  for (std::uint32_t i = 0; i < leaves.size(); ++i)
    if (leaves[i].fits) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Leaf &l = leaves[a], &m = leaves[b];
    if (l.sure != m.sure) return l.sure;
    return l.moments.n != m.moments.n ? l.moments.n > m.moments.n : a < b;
  });
  std::vector<Segment> segments;
  for (const std::uint32_t seed : order) {
    if (leaves[seed].segment != kNone) continue;
    const auto number = static_cast<std::uint32_t>(segments.size());
    Segment s{leaves[seed].moments, leaves[seed].fit.plane, {seed}};
    leaves[seed].segment = number;
    for (std::size_t at = 0; at < s.leaves.size(); ++at)
      for (const std::uint32_t j : beside[s.leaves[at]]) {
        Leaf& leaf = leaves[j];
        if (!leaf.fits || leaf.segment != kNone || !joins(s, leaf, params)) continue;
        leaf.segment = number;
        s.leaves.push_back(j);
        s.moments.add(leaf.moments);
        s.plane = fit_plane(s.moments).plane;
      }
    segments.push_back(std::move(s));
  }
  return segments;
}

// Returns the points without a label in the leaves of a segment and in neighbouring leaves that belong to no segment.
Indices candidates(const Octree& tree, const Segment& s, const std::vector<Indices>& beside,
                   const std::vector<std::uint32_t>& label) {
  Indices leaves = s.leaves;
  for (const std::uint32_t l : s.leaves)
    for (const std::uint32_t j : beside[l])
      if (tree.leaves[j].segment == kNone) leaves.push_back(j);
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  Indices points;
  for (const std::uint32_t l : leaves)
    for (const std::uint32_t i : tree.points_of(tree.leaves[l]))
      if (label[i] == 0) points.push_back(i);
  return points;
}

}  // namespace

PlaneSegments split_merge(Points points, const SplitMergeParams& params) {
  PlaneSegments result;
  result.label.assign(points.size, 0);
  Octree tree(points, params);
  const std::vector<Indices> beside = tree.contacts();
  std::vector<Segment> segments = merge(tree.leaves, beside, params);
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.moments.n > b.moments.n; });
  // Leaves of segments that are too small are free for other segments.
  for (const Segment& s : segments)
    if (s.moments.n < params.min_points)
      for (const std::uint32_t l : s.leaves) tree.leaves[l].segment = kNone;
  for (const Segment& s : segments) {
    if (s.moments.n < params.min_points) break;
    const RefinedPlane r = refine_plane({points}, candidates(tree, s, beside, result.label), s.plane,
                                        {params.epsilon, 0, params.min_points});
    if (r.members.size() < params.min_points) continue;
    result.planes.push_back(r.plane);
    for (const std::uint32_t i : r.members) result.label[i] = static_cast<std::uint32_t>(result.planes.size());
  }
  return result;
}

}  // namespace ilot
