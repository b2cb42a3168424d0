// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/place_neighbours.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostAround = 192;  // places that a query in cells examines
constexpr std::int32_t kMostRings = 4;    // of cells around its own
constexpr std::size_t kPlacesPerCell = 2;

constexpr int kTopLevel = 31;  // one cell for all points, because codes are below 2^62

// Returns the finest level at which occupied cells contain kPlacesPerCell places on average, or kTopLevel for fewer
// places.
int level_of(const PlaneOrder& order) {
  std::array<std::size_t, kTopLevel> starts{};  // per level the first places of cells that a finer level does not start
  for (std::size_t i = 1; i < order.codes.size(); ++i)
    ++starts[static_cast<std::size_t>((std::bit_width(order.codes[i] ^ order.codes[i - 1]) - 1) / 2)];
  std::size_t occupied = 1;
  int level = kTopLevel;
  for (; level > 0; --level) {
    occupied += starts[static_cast<std::size_t>(level) - 1];
    if (occupied * kPlacesPerCell > order.codes.size()) break;
  }
  return level;
}

constexpr int kMostInCells = 7;  // neighbours that the search in cells keeps

// Returns the k-th smallest of squared distances, without the 0 of the query itself. They are integers below 2^50,
// which are exact in double. They are kept in order without branches, which would be mispredicted.
double kth_smallest(std::span<const double> squared, int k) {
  std::array<double, kMostInCells + 1> least;
  least.fill(kNone);
  for (double d2 : squared)
    for (double& slot : least) {
      const double smaller = std::min(slot, d2);
      d2 = std::max(slot, d2);
      slot = smaller;
    }
  return least[static_cast<std::size_t>(k)];
}

// The search in cells for one query after the other.
class CellSearch {
 public:
  CellSearch(const PlaceCells& cells, int k, std::int64_t farthest)
      : cells_(cells), k_(k), limit2_(farthest * farthest) {}

  // Returns false when the query needs the tree.
  bool find(Point2 place, std::int64_t& squared) {
    const std::int32_t x = place.x - cells_.low.x, y = place.y - cells_.low.y;
    for (std::int32_t ring = 1; ring <= kMostRings; ++ring) {
      if (!gather(x, y, ring)) return false;
      const std::int64_t inside2 = squared_inside(x, y, ring);
      const double kth = kth_of_gathered();
      if (kth <= static_cast<double>(inside2)) {
        hint_ = 1.5 * kth;  // usually more than k places are as near
        squared = kth <= static_cast<double>(limit2_) ? static_cast<std::int64_t>(kth) : -1;
        return true;
      }
      if (inside2 >= limit2_) {
        squared = kth <= static_cast<double>(limit2_) ? static_cast<std::int64_t>(kth) : -1;
        return true;
      }
    }
    return false;
  }

 private:
  // Collects the squared distances to all places in the cells around (x, y).
  bool gather(std::int32_t x, std::int32_t y, std::int32_t ring) {
    const std::int32_t column = x >> cells_.shift, row = y >> cells_.shift;
    const std::int32_t left = std::max(0, column - ring), right = std::min(cells_.columns - 1, column + ring);
    size_ = 0;
    for (std::int32_t r = std::max(0, row - ring); r <= std::min(cells_.rows - 1, row + ring); ++r) {
      const std::size_t at = static_cast<std::size_t>(r) * static_cast<std::size_t>(cells_.columns);
      const std::uint32_t first = cells_.start[at + static_cast<std::size_t>(left)];
      const std::uint32_t end = cells_.start[at + static_cast<std::size_t>(right) + 1];
      if (size_ + (end - first) > kMostAround) return false;
      for (std::uint32_t i = first; i < end; ++i) {
        const double dx = cells_.x[i] - x, dy = cells_.y[i] - y;
        d2_[size_ + (i - first)] = dx * dx + dy * dy;
      }
      size_ += end - first;
    }
    return true;
  }

  // Returns a distance below which there is no place outside of the gathered cells.
  std::int64_t squared_inside(std::int32_t x, std::int32_t y, std::int32_t ring) const {
    const auto gap = [&](std::int32_t v, std::int32_t cells) {
      const std::int64_t low = (v >> cells_.shift) - ring, high = (v >> cells_.shift) + ring + 1;
      std::int64_t least = std::numeric_limits<std::int32_t>::max();
      if (low > 0) least = std::min(least, v - (low << cells_.shift));
      if (high < cells) least = std::min(least, (high << cells_.shift) - v);
      return least;
    };
    const std::int64_t g = std::min(gap(x, cells_.columns), gap(y, cells_.rows));
    return g * g;
  }

  // The queries before give a hint of the distance, so most of the other places need not be sorted.
  double kth_of_gathered() {
    std::array<double, kMostAround> near;
    std::size_t count = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      near[count] = d2_[i];
      count += d2_[i] <= hint_;
    }
    const bool enough = count > static_cast<std::size_t>(k_);
    return kth_smallest(enough ? std::span<const double>(near.data(), count) : std::span(d2_.data(), size_), k_);
  }

  const PlaceCells& cells_;
  int k_;
  std::size_t size_ = 0;
  std::int64_t limit2_;
  double hint_ = kNone;
  std::array<double, kMostAround> d2_;
};

void by_tree(const PlaceCells& cells, std::span<const std::uint32_t> queries, int k, std::int64_t farthest,
             std::span<std::int64_t> squared) {
  const std::size_t n = cells.places.size();
  constexpr std::size_t kBatch = 1024;
  PaddedPoints points;
  points.reset(n);
  for (std::size_t i = 0; i < n; ++i) {
    points.x[i] = static_cast<float>(cells.places[i].x - cells.low.x);
    points.y[i] = static_cast<float>(cells.places[i].y - cells.low.y);
  }
  const NeighbourIndex index = build_neighbour_index(points.points());
  const auto each = static_cast<std::size_t>(k + 1);
  std::vector<std::uint32_t> neighbours(kBatch * each);
  for (std::size_t done = 0; done < queries.size(); done += kBatch) {
    const std::size_t count = std::min(kBatch, queries.size() - done);
    knn(index, queries.subspan(done, count), {k + 1, farthest * farthest}, std::span(neighbours).first(count * each),
        squared.subspan(done, count));
  }
}

}  // namespace

PlaceCells place_cells(const PlaneOrder& order) {
  PlaceCells cells{order.points, {}, 0, 0, 0, {}, {}, {}};
  const std::size_t n = order.points.size();
  if (n == 0) return cells;
  Point2 high = order.points[0];
  cells.low = high;
  for (const Point2 p : order.points) {
    cells.low = {std::min(cells.low.x, p.x), std::min(cells.low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  cells.shift = level_of(order);
  const auto across = [&](std::int32_t extent) { return (std::int64_t{extent} >> cells.shift) + 1; };
  while (across(high.x - cells.low.x) * across(high.y - cells.low.y) > static_cast<std::int64_t>(4 * n + 64))
    ++cells.shift;
  cells.columns = static_cast<std::int32_t>(across(high.x - cells.low.x));
  cells.rows = static_cast<std::int32_t>(across(high.y - cells.low.y));
  const auto cell_of = [&](Point2 p) {
    return static_cast<std::size_t>((p.y - cells.low.y) >> cells.shift) * static_cast<std::size_t>(cells.columns) +
           static_cast<std::size_t>((p.x - cells.low.x) >> cells.shift);
  };
  cells.start.assign(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows) + 2, 0);
  for (const Point2 p : order.points) ++cells.start[cell_of(p) + 2];
  for (std::size_t c = 2; c < cells.start.size(); ++c) cells.start[c] += cells.start[c - 1];
  cells.x.resize(n);
  cells.y.resize(n);
  for (const Point2 p : order.points) {
    const std::uint32_t to = cells.start[cell_of(p) + 1]++;
    cells.x[to] = p.x - cells.low.x;
    cells.y[to] = p.y - cells.low.y;
  }
  return cells;
}

void kth_distances(const PlaceCells& cells, std::span<const std::uint32_t> queries, int k, std::int64_t farthest,
                   std::span<std::int64_t> squared) {
  if (k > kMostInCells) return by_tree(cells, queries, k, farthest, squared);
  CellSearch search(cells, k, farthest);
  std::vector<std::uint32_t> left, slots;
  for (std::uint32_t q = 0; q < queries.size(); ++q) {
    if (search.find(cells.places[queries[q]], squared[q])) continue;
    left.push_back(queries[q]);
    slots.push_back(q);
  }
  if (left.empty()) return;
  std::vector<std::int64_t> found(left.size());
  by_tree(cells, left, k, farthest, found);
  for (std::size_t i = 0; i < left.size(); ++i) squared[slots[i]] = found[i];
}

}  // namespace ilot
