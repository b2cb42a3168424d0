// SPDX-License-Identifier: Apache-2.0
// The distance of the k-th nearest place in a plane.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/plane_order.h"

namespace ilot {

// Square cells over the places of an order, row by row. A cell has about three places where they are evenly spread. The
// cells are those of the codes, so a cell is a run of the order.
struct PlaceCells {
  std::span<const Point2> places;  // not owned
  Point2 low;                      // corner of the first cell
  int shift = 0;                   // a cell is 2^shift wide
  std::int32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> start;  // per cell its first place in x and y, and one past the last
  std::vector<float> x, y;           // the places cell by cell, relative to low; padded for vector bodies
};

// O(n). The order must outlive the cells; its extent is below 2^24.
PlaceCells place_cells(const PlaneOrder& order);

// Returns for each query (a position in the order) the squared distance of the k-th nearest other place (k from 1 to
// 63). It is -1 when fewer are within `farthest`, which is at most 2^22. For k up to 7 most queries are answered from
// the cells around them. The others, which have many more or far fewer places around, are answered by a tree in O(log n
// + k). Queries in ascending order are the fastest.
void kth_distances(const PlaceCells& cells, std::span<const std::uint32_t> queries, int k, std::int64_t farthest,
                   std::span<std::int64_t> squared);

}  // namespace ilot
