// SPDX-License-Identifier: Apache-2.0
// A wall as an image of depths: what is foremost, seen square to it, and the connected regions before and behind it.
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/products/facades/openings/located_edge.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

enum DepthKind : std::int8_t { kBehind = -1, kWall = 0, kBefore = 1, kNothing = 2 };

constexpr double kAroundWall = 2.5;      // metres around the wall that the image covers: as far as things stand out
constexpr double kForemostSheet = 0.03;  // metres: points so far behind the foremost belong to its surface

// Row by row from below, columns along the wall.
struct DepthImage {
  double cell = 0;  // metres
  std::int64_t columns = 0, rows = 0;
  std::vector<float> front;       // metres out of the wall; -infinity where nothing was seen
  std::vector<std::int8_t> what;  // DepthKind

  // Left end of a column, lower end of a row: metres in the wall's axes.
  double u(std::int64_t c) const { return static_cast<double>(c) * cell - kAroundWall; }
  // The cell of a point; -1 outside of the image.
  std::int64_t at(const FacadePoint& p) const {
    const auto c = static_cast<std::int64_t>(std::floor((static_cast<double>(p.u) + kAroundWall) / cell));
    const auto r = static_cast<std::int64_t>(std::floor((static_cast<double>(p.v) + kAroundWall) / cell));
    return c < 0 || r < 0 || c >= columns || r >= rows ? -1 : r * columns + c;
  }
};

// Cells of two sampling steps, 3 to 15 cm, 2^21 of them at most. A cell is before (behind) the wall where what is
// foremost lies by `least_depth` before (behind) it; points farther than `most_depth` from the wall are left out. Cells
// that nothing was seen in become what five or more of their neighbours are. O(points).
DepthImage depth_image(const RaySamples& samples, double least_depth, double most_depth);

// Cells of one kind, before or behind the wall, that meet along their sides.
struct DepthRegion {
  std::int8_t what = kWall;
  std::vector<std::uint32_t> cells;
  std::int64_t c0 = 0, c1 = 0, r0 = 0, r1 = 0;  // its box, closed: where most of its rows and columns end, below
                                                // half of those of what stands out
};

// Calls visit for one after the other, by their first cells.
void for_each_depth_region(const DepthImage& image, const std::function<void(const DepthRegion&)>& visit);

// Share of a region's rows (columns) from whose end towards a side the wall is met.
double bounded_by_wall(const DepthImage& image, const DepthRegion& region, Side side);

}  // namespace ilot
