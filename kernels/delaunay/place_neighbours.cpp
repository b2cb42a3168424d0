// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/place_neighbours.h"

#include <algorithm>
#include <array>
#include <bit>

#include "kernels/delaunay/place_neighbours_body.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/knn.h"

namespace ilot {
namespace {

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
  cells.x.resize(n + kPointPadding);
  cells.y.resize(n + kPointPadding);
  for (const Point2 p : order.points) {
    const std::uint32_t to = cells.start[cell_of(p) + 1]++;
    cells.x[to] = static_cast<float>(p.x - cells.low.x);
    cells.y[to] = static_cast<float>(p.y - cells.low.y);
  }
  return cells;
}

void kth_distances(const PlaceCells& cells, std::span<const std::uint32_t> queries, int k, std::int64_t farthest,
                   std::span<std::int64_t> squared) {
  if (k > kMostInCells) return by_tree(cells, queries, k, farthest, squared);
  simd::kPlaceNeighbours.best().in_cells({cells.x.data(), cells.y.data(), cells.start.data(), cells.places.data(),
                                          cells.low, cells.shift, cells.columns, cells.rows, queries.data(),
                                          queries.size(), k, farthest * farthest, squared.data()});
  std::vector<std::uint32_t> left, slots;
  for (std::uint32_t q = 0; q < queries.size(); ++q) {
    if (squared[q] != simd::kNotInCells) continue;
    left.push_back(queries[q]);
    slots.push_back(q);
  }
  if (left.empty()) return;
  std::vector<std::int64_t> found(left.size());
  by_tree(cells, left, k, farthest, found);
  for (std::size_t i = 0; i < left.size(); ++i) squared[slots[i]] = found[i];
}

}  // namespace ilot
