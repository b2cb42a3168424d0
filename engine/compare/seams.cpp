// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <span>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "engine/store/lattice.h"
#include "kernels/core/parallel_sort.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

constexpr int kParts = 8;                   // lines in a cell and its border
constexpr std::size_t kNearestToLine = 16;  // points of a side that are compared with those of the other

// A cell of any size: its corner and its edge in steps.
struct Leaf {
  Index3 corner;
  std::int64_t edge = 0;
  friend bool operator==(const Leaf&, const Leaf&) = default;
};

struct LeafHash {
  std::size_t operator()(const Leaf& l) const {
    std::uint64_t h = static_cast<std::uint64_t>(l.edge);
    for (const std::int64_t v : {l.corner.x, l.corner.y, l.corner.z})
      h = (h ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u, h ^= h >> 32;
    return h;
  }
};

std::int64_t floored(std::int64_t v, std::int64_t edge) {
  return v & ~(edge - 1);  // edges are powers of two
}

// The cells of all points. Cells with too many points are cut, as the search for planes cuts them.
class Leaves {
 public:
  Leaves(const std::vector<Index3>& places, const SeamCells& cells) : edge_(cells.edge) {
    std::vector<std::uint32_t> open(places.size());
    for (std::uint32_t i = 0; i < open.size(); ++i) open[i] = i;
    for (std::int64_t edge = cells.edge; edge > 1 && !open.empty(); edge /= 2) {
      std::unordered_map<Leaf, std::uint64_t, LeafHash> counts;
      for (const std::uint32_t i : open) ++counts[at(places[i], edge)];
      std::size_t left = 0;
      for (const std::uint32_t i : open) {
        const Leaf leaf = at(places[i], edge);
        if (counts[leaf] <= cells.points) continue;
        cut_.insert(leaf);
        open[left++] = i;
      }
      open.resize(left);
    }
  }

  Leaf of(Index3 p) const {
    Leaf leaf = at(p, edge_);
    while (leaf.edge > 1 && cut_.contains(leaf)) leaf = at(p, leaf.edge / 2);
    return leaf;
  }

 private:
  static Leaf at(Index3 p, std::int64_t edge) {
    return {{floored(p.x, edge), floored(p.y, edge), floored(p.z, edge)}, edge};
  }
  std::int64_t edge_;
  std::unordered_set<Leaf, LeafHash> cut_;
};

// A point near a line, on one side of it.
struct Near {
  std::int32_t axis = 0;      // 0 = the line is at one x, 1 = at one y
  std::int64_t line = 0;      // steps
  std::int64_t stretch = 0;   // along the line
  bool behind = false;        // on the side of greater coordinates
  std::int64_t distance = 0;  // from the line, in half steps
  std::uint32_t point = 0;
  auto key() const { return std::tie(axis, line, stretch, behind, distance, point); }
};

double squared_distance(Index3 a, Index3 b) {
  const auto dx = static_cast<double>(a.x - b.x), dy = static_cast<double>(a.y - b.y);
  const auto dz = static_cast<double>(a.z - b.z);
  return dx * dx + dy * dy + dz * dz;
}

// The nearest two points of the two sides of a stretch.
std::pair<std::uint32_t, std::uint32_t> nearest_pair(std::span<const Near> before, std::span<const Near> behind,
                                                     const std::vector<Index3>& places) {
  std::pair<std::uint32_t, std::uint32_t> best;
  double least = INFINITY;
  for (const Near& a : before.first(std::min(before.size(), kNearestToLine)))
    for (const Near& b : behind.first(std::min(behind.size(), kNearestToLine))) {
      const double d2 = squared_distance(places[a.point], places[b.point]);
      if (d2 >= least) continue;
      least = d2;
      best = {a.point, b.point};
    }
  return best;
}

// The difference in height between the lowest and the highest of these points.
std::int64_t rise_of(std::span<const Near> near, const std::vector<Index3>& places) {
  const auto [low, high] = std::minmax_element(
      near.begin(), near.end(), [&](const Near& a, const Near& b) { return places[a.point].z < places[b.point].z; });
  return places[high->point].z - places[low->point].z;
}

std::vector<Near> points_near_lines(const SeamPoints& points, const Leaves& leaves, double stretch,
                                    std::int64_t reach) {
  std::vector<Near> near;
  for (std::uint32_t i = 0; i < points.places.size(); ++i) {
    const Index3 p = points.places[i];
    const Leaf leaf = leaves.of(p);
    const std::int64_t apart = leaf.edge / kParts;
    if (apart < 2) continue;
    const std::int64_t most = std::min(reach, apart / 2);
    for (const int axis : {0, 1}) {
      const std::int64_t across = axis == 0 ? p.x : p.y, along = axis == 0 ? p.y : p.x;
      const std::int64_t line = floored(across + apart / 2, apart);
      if (across - line >= most || line - across > most) continue;
      near.push_back({axis, line, static_cast<std::int64_t>(std::floor(static_cast<double>(along) / stretch)),
                      across >= line, std::abs(2 * (across - line) + 1), i});
    }
  }
  parallel_sort(near, [](const Near& a, const Near& b) { return a.key() < b.key(); });
  return near;
}

}  // namespace

std::optional<double> CutCounts::share() const {
  if (stretches == 0) return std::nullopt;
  return static_cast<double>(cut) / static_cast<double>(stretches);
}

std::optional<double> PairCounts::share() const {
  if (pairs == 0) return std::nullopt;
  return static_cast<double>(equal) / static_cast<double>(pairs);
}

Seams measure_seams(const SeamPoints& points, const SeamCells& cells, const SeamParams& params,
                    double metres_per_unit) {
  Seams seams;
  seams.cells = cells;
  seams.points = points.places.size();
  std::unordered_set<std::uint32_t> planes;
  for (const std::uint32_t plane : points.plane) {
    seams.unlabelled += plane == 0;
    if (plane != 0) planes.insert(plane);
  }
  seams.planes = static_cast<std::uint32_t>(planes.size());
  const double step_m = cells.unit * metres_per_unit;
  const Leaves leaves(points.places, cells);
  const std::vector<Near> near =
      points_near_lines(points, leaves, params.stretch_m / step_m, static_cast<std::int64_t>(params.reach_m / step_m));
  const auto highest = static_cast<std::int64_t>(params.height_m / step_m);
  const auto same_stretch = [](const Near& a, const Near& b) {
    return a.axis == b.axis && a.line == b.line && a.stretch == b.stretch;
  };
  for (std::size_t begin = 0, end = 0; begin < near.size(); begin = end) {
    std::size_t middle = begin;
    for (end = begin; end < near.size() && same_stretch(near[begin], near[end]); ++end) middle += !near[end].behind;
    if (middle == begin || middle == end) continue;
    if (rise_of(std::span(near).subspan(begin, end - begin), points.places) > highest) continue;
    const auto all = std::span(near);
    const auto [a, b] =
        nearest_pair(all.subspan(begin, middle - begin), all.subspan(middle, end - middle), points.places);
    const Index3 p = points.places[a], q = points.places[b];
    CutCounts& counts = leaves.of(p) == leaves.of(q) ? seams.elsewhere : seams.borders;
    ++counts.stretches;
    counts.cut += points.plane[a] == 0 || points.plane[a] != points.plane[b];
  }
  return seams;
}

PairCounts compare_pairs(const SeamPoints& points, const std::vector<std::uint32_t>& other, double metres_per_step,
                         const SeamParams& params) {
  std::vector<std::pair<PointKey, std::uint32_t>> order(points.places.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {key_of(points.places[i]), i};
  parallel_sort(order, [](const auto& a, const auto& b) { return a < b; });
  PairCounts counts;
  if (order.empty()) return counts;
  const Index3 anchor = points.places[order[0].second];
  PaddedPoints sorted;
  for (const auto& [key, i] : order) {
    const Index3 p = points.places[i];
    sorted.add(static_cast<float>(p.x - anchor.x), static_cast<float>(p.y - anchor.y),
               static_cast<float>(p.z - anchor.z));
  }
  sorted.pad();
  const NeighbourIndex index = build_neighbour_index(sorted.points());
  const auto reach = static_cast<std::int64_t>(params.reach_m / metres_per_step);
  constexpr std::uint32_t kBatch = 4096, kLists = kPairNeighbours + 1;
  std::vector<std::uint32_t> queries, lists(std::size_t{kBatch} * kLists);
  std::vector<std::int64_t> reach2(kBatch);
  for (std::uint32_t first = 0; first < sorted.size; first += kBatch) {
    queries.clear();
    for (std::uint32_t i = first; i < sorted.size && i < first + kBatch; ++i) queries.push_back(i);
    const auto found = std::span(lists).first(queries.size() * kLists);
    knn(index, queries, {kLists, reach * reach}, found, std::span(reach2).first(queries.size()));
    for (std::size_t k = 0; k < found.size(); ++k) {
      const std::uint32_t i = order[queries[k / kLists]].second;
      if (found[k] == kNoNeighbour) continue;
      const std::uint32_t j = order[found[k]].second;
      const auto rise = static_cast<double>(points.places[i].z - points.places[j].z);
      if (i == j || std::abs(rise) * metres_per_step > params.height_m) continue;
      const bool same = points.plane[i] != 0 && points.plane[i] == points.plane[j];
      const bool same_other = other[i] != 0 && other[i] == other[j];
      ++counts.pairs;
      counts.equal += same == same_other;
      counts.different += !same;
      counts.different_other += !same_other;
    }
  }
  return counts;
}

}  // namespace ilot
