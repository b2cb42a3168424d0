// SPDX-License-Identifier: Apache-2.0
// How far the k-th nearest place of a plane is.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/plane_order.h"

namespace ilot {

// Square cells over the places of an order, row by row, of about three places each where they lie evenly. They are the
// cells of the codes, so a cell is a run of the order.
struct PlaceCells {
  std::span<const Point2> places;  // not owned
  Point2 low;                      // corner of the first cell
  int shift = 0;                   // a cell is 2^shift wide
  std::int32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> start;  // per cell its first place in x and y, and one past the last
  std::vector<std::int32_t> x, y;    // the places by cells, relative to low
};

// O(n). The order must outlive the cells; its extent is below 2^24.
PlaceCells place_cells(const PlaneOrder& order);

// Per query, a position in the order, the squared distance of the k-th nearest other place (k from 1 to 63), -1 when
// fewer lie within `farthest`, at most 2^22. For k up to 7 most are answered from the cells around them; the others,
// with far more or far fewer places around, by a tree: O(log n + k) anywhere. Queries in ascending order are the
// fastest.
void kth_distances(const PlaceCells& cells, std::span<const std::uint32_t> queries, int k, std::int64_t farthest,
                   std::span<std::int64_t> squared);

}  // namespace ilot
