// SPDX-License-Identifier: Apache-2.0
// A wall as an image of depths, which shows the foremost points seen at right angles to the wall, and the connected
// regions in front of the wall and behind it.
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"
#include "engine/products/facades/sides/located_edge.h"

namespace ilot {

enum DepthKind : std::int8_t { kBehind = -1, kWall = 0, kBefore = 1, kNothing = 2 };

// Choice: as facades.most_relief; a canopy that stands out farther is cut.
constexpr double kAroundWall = 2.5;  // metres around the wall that the image covers; no element stands out farther
// Choice: the noise of terrestrial scanners (3 to 8 mm) four times; two surfaces nearer to each other count as one.
constexpr double kForemostSheet = 0.03;  // metres; points at most this far behind the foremost one are on its surface

// Cells are stored row by row from the bottom; columns go along the wall.
struct DepthImage {
  double cell = 0;  // metres
  std::int64_t columns = 0, rows = 0;
  std::vector<float> front;       // metres out of the wall; -infinity where nothing was seen
  std::vector<std::int8_t> what;  // DepthKind

  // The left end of a column; the function for rows gives the lower end. In metres, in the axes of the wall.
  double u(std::int64_t c) const { return static_cast<double>(c) * cell - kAroundWall; }
  // The cell of a point; -1 if the point is outside of the image.
  std::int64_t at(const FacadePoint& p) const {
    const auto c = static_cast<std::int64_t>(std::floor((static_cast<double>(p.u) + kAroundWall) / cell));
    const auto r = static_cast<std::int64_t>(std::floor((static_cast<double>(p.v) + kAroundWall) / cell));
    return c < 0 || r < 0 || c >= columns || r >= rows ? -1 : r * columns + c;
  }
};

// The cells have an edge of two sampling steps, between 3 and 15 cm; there are at most 2^21 of them. A cell is before
// (behind) the wall where the foremost points lie at least `least_depth` before (behind) it. Points farther than
// `most_depth` from the wall are left out. A cell in which nothing was seen takes the kind of its neighbours if five or
// more of them agree. O(points).
DepthImage depth_image(const RaySamples& samples, double least_depth, double most_depth);

// Cells of one kind, before or behind the wall, that are joined along their sides.
struct DepthRegion {
  std::int8_t what = kWall;
  std::vector<std::uint32_t> cells;
  std::int64_t c0 = 0, c1 = 0, r0 = 0, r1 = 0;  // its closed box: where most rows and columns end; for what stands out,
                                                // the place where half of the columns end below
};

// Calls visit for each region, in the order of their first cells.
void for_each_depth_region(const DepthImage& image, const std::function<void(const DepthRegion&)>& visit);

// The share of the rows (columns) of a region that meet the wall at their end towards the side.
double bounded_by_wall(const DepthImage& image, const DepthRegion& region, Side side);

}  // namespace ilot
