// SPDX-License-Identifier: Apache-2.0
// A town of any size as a pure function of a seed: square cells, each a neighbourhood with its own street
// direction, rows of detached and adjoining houses, and trees. Cells do not depend on each other.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/districts/house.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

struct DistrictParams {
  double side = 240;         // metres, of the square area
  double slope_percent = 2;  // of the ground
  double trees = 15;         // per hectare
  double adjoining = 0.4;    // share of groups of houses that are terraces
  double flat = 0.25;        // shares of roof shapes; the rest are gables
  double hip = 0.25;
  double clearance = 8;  // metres without anything at a cell's border, so that no ray of one cell meets another
  std::uint64_t seed = 0;
};

// Nothing in a district stands higher above the ground than this.
constexpr double kMaxHouseHeight = 18;  // metres

struct Rect {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // half-open
};

// Everything that stands in one cell. Coordinates are metres from the lower left corner of the district.
struct Cell {
  Rect area;
  std::vector<HouseForm> houses;
  std::vector<Face> faces;                   // of all houses
  std::vector<std::uint32_t> face_building;  // index into houses
  std::vector<std::uint32_t> face_plane;     // 0-based: connected coplanar faces share one; dense, by first face
  std::uint32_t plane_count = 0;
  std::vector<ConvexSolid> solids;  // one per house
  std::vector<Crown> crowns;
};

class District {
 public:
  explicit District(const DistrictParams& params);

  const Ground& ground() const { return ground_; }
  std::uint64_t cell_count() const { return cells_per_side_ * cells_per_side_; }

  // The cell of a row-major index. Pure: any thread, any order, same result. About a hundred houses.
  Cell build_cell(std::uint64_t index) const;

 private:
  DistrictParams params_;
  std::uint64_t cells_per_side_ = 1;
  Ground ground_;
};

}  // namespace ilot::scan
