// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <vector>

#include "engine/store/store.h"
#include "kernels/geometry/box3.h"
#include "kernels/geometry/padded_points.h"

namespace ilot {

// Consecutive points of one block inside a view.
struct Slice {
  std::uint32_t block = 0;
  std::uint32_t first = 0, count = 0;  // in the block
  std::uint32_t at = 0;                // in the view
};

// Points of the store around a place, in global order, as offsets from an anchor. It contains every point of the
// requested box and also others, because whole chunks are read.
struct View : PaddedPoints {
  Index3 anchor;
  std::vector<Slice> slices;

  // Returns the place of a point on the lattice.
  Index3 position(std::uint32_t i) const {
    return {static_cast<std::int64_t>(x[i]) + anchor.x, static_cast<std::int64_t>(y[i]) + anchor.y,
            static_cast<std::int64_t>(z[i]) + anchor.z};
  }
};

// Returns the slices that cover the box and their number of points, without reading the points.
View plan_view(const Store& store, const IndexBox& box, Index3 anchor);

// Takes only the chunks whose boxes are wanted, for shapes that are not parallel to the axes.
View plan_view(const Store& store, const IndexBox& box, Index3 anchor,
               const std::function<bool(const IndexBox&)>& wanted);

// Reads the coordinates of a planned view. 12 bytes a point.
void load_points(const Store& store, View& view);

inline View load_view(const Store& store, const IndexBox& box, Index3 anchor) {
  View view = plan_view(store, box, anchor);
  load_points(store, view);
  return view;
}

// Reads another column of the same points, in the order of the view.
template <class T>
std::vector<T> load_column(const Store& store, const View& view, const Column<T>& column) {
  std::vector<T> values(view.size);
  for (const Slice& s : view.slices)
    store.open(s.block, column).read(s.first, std::span(values).subspan(s.at, s.count));
  return values;
}

// The positions in the view of the points of one block: [begin, end).
struct PointRange {
  std::uint32_t begin = 0, end = 0;
};
PointRange range_of_block(const View& view, std::uint32_t block);

}  // namespace ilot
