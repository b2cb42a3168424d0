// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <compare>
#include <cstdint>
#include <vector>

#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// A square of a lattice of squares whose corners are at multiples of their side.
struct PointWindow {
  std::int64_t row = 0, column = 0;
  friend auto operator<=>(const PointWindow&, const PointWindow&) = default;
};

// Returns the windows of `side` lattice units that contain a point of the store, row by row. They are the windows of
// the points themselves and not of bounding boxes, so a point far from all others adds one window. Reads the codes of
// blocks that reach over the border of a window. O(points). Memory: 16 bytes per window and a stretch of points per
// thread.
std::vector<PointWindow> windows_with_points(const Store& store, const PassContext& context, std::int64_t side);

}  // namespace ilot
