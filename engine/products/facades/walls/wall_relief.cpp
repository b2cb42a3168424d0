// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_relief.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: cornices and plinths reach beyond a wall by less.
constexpr double kBelow = 0.5;  // metres above and below a wall in which its relief may be
// Derived: a majority.
constexpr double kAlongWall = 0.5;  // share of the width of a plane that must be along the wall so that it is relief

bool is_part_of(const Segment& s, const WallGroup& group) {
  return std::binary_search(group.segments.begin(), group.segments.end(), s.id);
}

// The boxes of the segments of a wall.
std::vector<WallExtent> boxes_of(const SegmentGrid& grid, const WallGroup& group, const WallParams& params) {
  const WallExtent around{0, group.width, 0, group.height, -params.bias, params.bias};
  std::vector<WallExtent> boxes;
  for (const std::uint32_t k : grid.near(group.axes, around))
    if (is_part_of(grid.segment(k), group))
      boxes.push_back(extent_of(grid.segment(k), group.axes, params.metres_per_unit));
  return boxes;
}

bool surrounds(const WallExtent& outer, const WallExtent& e) {
  return e.u0 >= outer.u0 && e.u1 <= outer.u1 && e.v0 >= outer.v0 && e.v1 <= outer.v1;
}

}  // namespace

std::vector<std::size_t> relief_of(const SegmentGrid& grid, const WallParams& params, std::span<const KnownPart> parts,
                                   const WallGroup& group) {
  const double least_cos = cos_degrees(kParallelDeg);
  const WallExtent around{0, group.width, -kBelow, group.height + kBelow, -params.relief_behind, params.relief_front};
  std::vector<std::size_t> found;
  for (const std::uint32_t k : grid.near(group.axes, around)) {
    const Segment& s = grid.segment(k);
    if (std::abs(dot(s.plane.n, group.axes.out)) < least_cos || is_part_of(s, group)) continue;
    const WallExtent e = extent_of(s, group.axes, params.metres_per_unit);
    const double common = std::min(e.u1, group.width) - std::max(e.u0, 0.0);
    if (e.w0 > params.relief_front || e.w0 < -params.relief_behind || !(common >= kAlongWall * (e.u1 - e.u0)) ||
        e.v0 > group.height + kBelow || e.v1 < -kBelow)
      continue;
    const double beside = std::min(e.v1, group.height) - std::max(e.v0, 0.0);
    if (s.area_m2 >= params.least_area && beside < kAlongWall * (e.v1 - e.v0))
      continue;  // an upper storey that is set back
    if (!parts.empty() && is_beside(e, s, parts, params)) continue;
    found.push_back(k);
  }
  std::sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) { return grid.index(a) < grid.index(b); });
  return found;
}

std::optional<std::size_t> larger_plane(const SegmentGrid& grid, const std::vector<char>& taken,
                                        const WallParams& params, std::span<const KnownPart> parts,
                                        const WallGroup& group) {
  struct Part {
    std::size_t index;
    double w, area;
  };
  const std::vector<WallExtent> own = boxes_of(grid, group, params);
  std::vector<Part> beside;  // the largest first
  for (const std::size_t k : relief_of(grid, params, parts, group)) {
    const Segment& s = grid.segment(k);
    const WallExtent e = extent_of(s, group.axes, params.metres_per_unit);
    const bool inside = std::any_of(own.begin(), own.end(), [&](const WallExtent& box) { return surrounds(box, e); });
    if (taken[grid.index(k)] == 0 && std::abs(e.w0) > params.bias && !inside)
      beside.push_back({grid.index(k), e.w0, s.area_m2});
  }
  std::stable_sort(beside.begin(), beside.end(), [](const Part& a, const Part& b) { return a.area > b.area; });
  std::optional<std::size_t> larger;
  double most = group.area_m2;
  for (const Part& first : beside) {
    if (first.area < params.least_area / 4) break;  // no wall begins with less
    double area = 0;
    for (const Part& p : beside) area += std::abs(p.w - first.w) <= params.bias ? p.area : 0;
    if (area > most) most = area, larger = first.index;
  }
  return larger;
}

}  // namespace ilot
