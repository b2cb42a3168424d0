// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/maps/map_sheets.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kernels/geometry/flat_segment.h"

namespace ilot {
namespace {

// Choice: posts are half a millimetre wide, and a side of a sheet of A3 is the length of a block.
constexpr double kLargestScale = 250;
constexpr std::size_t kMostSheets = 40;  // Choice: a folder that one person carries

using Cells = std::set<std::pair<std::int64_t, std::int64_t>>;  // row from the north, column

// The cells of a grid in which something is drawn.
class DrawnCells {
 public:
  explicit DrawnCells(const SheetGrid& grid) : grid_(grid) {}
  void add(const MapShape& shape) {
    if (shape.lines.empty()) for_cells(shape.box(), [](const FlatBox&) { return true; });
    for (const std::vector<FlatPoint>& line : shape.lines)
      for (std::size_t i = 0; i + 1 < line.size() + shape.closed; ++i) {
        const FlatPoint a = line[i], b = line[(i + 1) % line.size()];
        FlatBox around = FlatBox::none();
        around.add(a), around.add(b);
        for_cells(around, [&](const FlatBox& cell) { return meets(a, b, cell); });
      }
  }
  const Cells& cells() const { return cells_; }

 private:
  template <class Meets>
  void for_cells(const FlatBox& box, const Meets& meets_cell) {
    const auto of = [](double v, double corner, double size) {
      return static_cast<std::int64_t>(std::floor((v - corner) / size));
    };
    for (std::int64_t row = of(box.min.y, grid_.corner.y, grid_.size.y);
         row <= of(box.max.y, grid_.corner.y, grid_.size.y); ++row)
      for (std::int64_t column = of(box.min.x, grid_.corner.x, grid_.size.x);
           column <= of(box.max.x, grid_.corner.x, grid_.size.x); ++column) {
        const double x = grid_.corner.x + static_cast<double>(column) * grid_.size.x;
        const double y = grid_.corner.y + static_cast<double>(row) * grid_.size.y;
        if (meets_cell({{x, y}, {x + grid_.size.x, y + grid_.size.y}})) cells_.insert({-row, column});
      }
  }

  const SheetGrid& grid_;
  Cells cells_;
};

// The sheets around the middle of the map: the borders of what is drawn lie as far from the borders of sheets on both
// sides. Of more sheets than are wanted some are left out.
SheetGrid grid_at(const StreetShapes& map, FlatPoint frame_mm, double scale) {
  SheetGrid grid;
  grid.scale = scale;
  grid.size = {frame_mm.x * scale / 1000, frame_mm.y * scale / 1000};
  const auto half = [](double length, double size) { return std::max(1.0, std::ceil(length / size)) * size / 2; };
  const FlatPoint middle = map.box.middle();
  grid.corner = {middle.x - half(map.box.width(), grid.size.x), middle.y - half(map.box.height(), grid.size.y)};
  DrawnCells drawn(grid);
  for (std::size_t i = 0; i < map.shapes.size() && drawn.cells().size() <= kMostSheets; ++i) drawn.add(map.shapes[i]);
  for (const auto& [row, column] : drawn.cells()) grid.sheets.push_back({column, -row});
  if (grid.sheets.empty()) grid.sheets.push_back({0, 0});
  return grid;
}

double round_number(double value, bool up) {
  if (!(value > 0)) return 1;
  double decade = 1;
  while (decade > value) decade /= 10;
  while (decade * 10 <= value) decade *= 10;
  for (const double digit : {5.0, 2.0, 1.0})
    if (!up && digit * decade <= value) return digit * decade;
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * decade >= value) return digit * decade;
  return 10 * decade;
}

}  // namespace

double round_up(double value) {
  return round_number(value, true);
}

double round_down(double value) {
  return round_number(value, false);
}

FlatBox SheetGrid::ground(std::size_t sheet) const {
  const FlatPoint least{corner.x + static_cast<double>(sheets[sheet].column) * size.x,
                        corner.y + static_cast<double>(sheets[sheet].row) * size.y};
  return {least, {least.x + size.x, least.y + size.y}};
}

std::size_t SheetGrid::number_beside(std::size_t sheet, std::int64_t columns, std::int64_t rows) const {
  for (std::size_t i = 0; i < sheets.size(); ++i)
    if (sheets[i].column == sheets[sheet].column + columns && sheets[i].row == sheets[sheet].row + rows) return i + 1;
  return 0;
}

SheetGrid sheets_of(const StreetShapes& map, FlatPoint frame_mm) {
  for (double scale = kLargestScale;; scale = round_up(scale + 1)) {
    SheetGrid grid = grid_at(map, frame_mm, scale);
    if (grid.sheets.size() <= kMostSheets) return grid;
  }
}

}  // namespace ilot
