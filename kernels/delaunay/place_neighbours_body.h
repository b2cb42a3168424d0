// SPDX-License-Identifier: Apache-2.0
// Raw arguments of the vector bodies in place_neighbours.inl, compiled once for each instruction set;
// place_neighbours.h says what they mean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "kernels/geometry/point2.h"
#include "kernels/simd/variants.h"

namespace ilot::simd {

constexpr std::int64_t kNotInCells = -2;  // the tree has to answer the query

struct PlaceNeighboursArgs {
  const float *x, *y;  // of the places cell by cell; 8 elements behind the last one can be read
  const std::uint32_t* start;
  const Point2* places;
  Point2 low;
  int shift;
  std::int32_t columns, rows;
  const std::uint32_t* queries;
  std::size_t query_count;
  int k;  // at most 7
  std::int64_t limit2;
  std::int64_t* squared;  // one per query
};

struct PlaceNeighboursBody {
  void (*in_cells)(const PlaceNeighboursArgs&);
};
extern const Variants<PlaceNeighboursBody> kPlaceNeighbours;

}  // namespace ilot::simd
