// SPDX-License-Identifier: Apache-2.0
// A map of the positions of outlines, which finds the neighbours of each.
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

// Derived: the grid of outlines is 1 mm.
constexpr double kGridMetres = 0.001;  // a step of the grid

// A closed box on the millimetre grid of the CRS. A grid coordinate is a coordinate of the CRS in metres, times 1,000,
// rounded.
struct GridBox {
  std::int64_t min_x = 0, min_y = 0, max_x = -1, max_y = -1;

  bool empty() const { return max_x < min_x; }
  bool meets(const GridBox& o) const {
    return min_x <= o.max_x && o.min_x <= max_x && min_y <= o.max_y && o.min_y <= max_y;
  }
  GridBox grown(std::int64_t by) const { return {min_x - by, min_y - by, max_x + by, max_y + by}; }
};

struct PlacedOutline {
  std::int64_t x = 0, y = 0;  // position of the anchor on the grid; whole metres
  SitePolygon polygon;        // from the anchor; empty = none
  GridBox box;                // of the polygon, on the grid
};

// Gives the polygon an anchor of its own: the whole metre at or below its lower corner. The vertices are on the grid
// and within 500 km of each other.
PlacedOutline place_outline(const std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>>& rings);

// The polygon relative to another anchor.
SitePolygon seen_from(const PlacedOutline& outline, std::int64_t x, std::int64_t y);

class OutlineMap {
 public:
  // Takes the boxes of outlines; the box of a site without an outline is empty. Memory: 32 bytes per outline, and 24
  // for each cell of 65 m in which it lies.
  explicit OutlineMap(std::vector<GridBox> boxes);

  // Returns the outlines whose boxes meet the box, ascending. About O(answers) for boxes of the size of buildings.
  std::vector<std::uint32_t> near(const GridBox& box) const;

 private:
  struct Entry {
    std::int64_t row, column;
    std::uint32_t outline;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  std::vector<GridBox> boxes_;
  std::vector<Entry> entries_;        // ascending
  std::vector<std::uint32_t> large_;  // too large for the cells
};

}  // namespace ilot
