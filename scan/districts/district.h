// SPDX-License-Identifier: Apache-2.0
// A town of any size as a pure function of a seed. It consists of square cells. Each cell is a neighbourhood with its
// own street direction, rows of detached and adjoining houses, and trees. Cells do not depend on each other.
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
  double flat = 0.25;        // share of flat roofs; what is neither flat nor hip is a gable
  double hip = 0.25;         // share of hip roofs
  double clearance = 8;      // metres left empty at a cell's border, so that no ray of one cell meets another
  std::uint64_t seed = 0;
};

// Nothing in a district is higher above the ground than this.
constexpr double kMaxHouseHeight = 18;  // metres

struct Rect {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // half-open
};

// The contents of one cell. Coordinates are metres from the lower left corner of the district.
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

  // Builds the cell with a row-major index. The function is pure: the result does not depend on the thread or on the
  // order of calls. A cell has about a hundred houses.
  Cell build_cell(std::uint64_t index) const;

 private:
  DistrictParams params_;
  std::uint64_t cells_per_side_ = 1;
  Ground ground_;
};

}  // namespace ilot::scan
