// SPDX-License-Identifier: Apache-2.0
// Segments by place, so that a wall looks only at those around it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/segment.h"
#include "engine/products/facades/facade_site.h"
#include "engine/products/facades/walls/box_grid.h"

namespace ilot {

// A box in the axes of a wall, in metres.
struct WallExtent {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0, w0 = 0, w1 = 0;
};

// The box of a segment in the axes, in metres; w0 and w1 are those of its centroid.
WallExtent extent_of(const Segment& s, const FacadeAxes& axes, double metres);

class SegmentGrid {
 public:
  // `list` holds indices into the segments, which must outlive the grid.
  SegmentGrid(std::span<const Segment> segments, std::vector<std::size_t> list, double metres);
  // Positions in the list, ascending, of segments that may reach into a box in the axes.
  std::vector<std::uint32_t> near(const FacadeAxes& axes, const WallExtent& e) const;
  const Segment& segment(std::size_t k) const { return segments_[list_[k]]; }
  std::size_t index(std::size_t k) const { return list_[k]; }
  const std::vector<std::size_t>& list() const { return list_; }
  double metres() const { return metres_; }

 private:
  // Choice: a cell has a few walls; time alone depends on it.
  static constexpr double kCell = 16;  // metres
  std::span<const Segment> segments_;
  std::vector<std::size_t> list_;
  double metres_;
  BoxGrid grid_;
};

}  // namespace ilot
