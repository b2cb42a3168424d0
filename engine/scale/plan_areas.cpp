// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_areas.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/products/roofs/roof_setup.h"

namespace ilot {
namespace {

constexpr double kMillimetresPerMetre = 1000;
// Choice: a task of some minutes; larger ones lose more when a worker dies, smaller ones read more halo.
constexpr double kPointsOfArea = 10e6;
// Choice: halos are then at most half of what is read.
constexpr double kLeastHalos = 5;  // side of an area in halos
constexpr double kRoundTo = 10;    // metres

// The whole number of a square of this side in which a coordinate lies, both in the same unit.
std::int64_t square_of(std::int64_t at, std::int64_t side) {
  return at >= 0 ? at / side : -((-at + side - 1) / side);
}

IndexBox read_box(const GridBox& box, double halo, double step) {
  const auto low = [&](std::int64_t mm) {
    return static_cast<std::int64_t>(std::floor((static_cast<double>(mm) / kMillimetresPerMetre - halo) / step)) - 1;
  };
  const auto high = [&](std::int64_t mm) {
    return static_cast<std::int64_t>(std::ceil((static_cast<double>(mm) / kMillimetresPerMetre + halo) / step)) + 1;
  };
  return column_over(low(box.min_x), low(box.min_y), high(box.max_x), high(box.max_y));
}

}  // namespace

double suitable_area_size(const PointMap& map, double step_metres, double halo) {
  std::uint64_t points = 0;
  for (const auto& [square, count] : map.squares()) points += count;
  const double side = std::ldexp(step_metres, map.bits());
  const double occupied = side * side * static_cast<double>(std::max<std::size_t>(1, map.squares().size()));
  const double size = std::sqrt(kPointsOfArea * occupied / static_cast<double>(std::max<std::uint64_t>(1, points)));
  return std::ceil(std::max(size, kLeastHalos * halo) / kRoundTo) * kRoundTo;
}

std::vector<PlanArea> cut_cell_areas(const PointMap& map, const CellAreaParams& params) {
  const std::int64_t side = params.cell * params.cells;
  std::set<PlanSquare> squares;  // of the areas
  for (const auto& [square, points] : map.squares()) {
    const auto last = [&](std::int64_t at) { return square_of(((at + 1) << map.bits()) - 1, side); };
    for (std::int64_t row = square_of(square.first << map.bits(), side); row <= last(square.first); ++row)
      for (std::int64_t column = square_of(square.second << map.bits(), side); column <= last(square.second); ++column)
        squares.emplace(row, column);
  }
  std::vector<PlanArea> areas;
  for (const auto& [row, column] : squares) {
    PlanArea& area = areas.emplace_back();
    area.row = row;
    area.column = column;
    const std::int64_t x = column * side, y = row * side, h = params.halo;
    area.own = column_over(x, y, x + side - 1, y + side - 1);
    area.read = column_over(x - h, y - h, x + side - 1 + h, y + side - 1 + h);
  }
  return areas;
}

std::vector<AreaSites> cut_areas(std::span<const PlannedSite> sites, std::vector<PlanArea> cells, double step_metres,
                                 const AreaParams& params) {
  const auto number = [&](std::int64_t mm) {  // of the squares; their side may be no whole number of millimetres
    return static_cast<std::int64_t>(std::floor(static_cast<double>(mm) / (params.size * kMillimetresPerMetre)));
  };
  std::map<std::pair<std::int64_t, std::int64_t>, AreaSites> areas;
  for (PlanArea& area : cells) areas[{area.row, area.column}].area = std::move(area);
  std::vector<std::size_t> nowhere;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const PlacedOutline& o = sites[i].outline;
    if (o.polygon.empty()) {
      nowhere.push_back(i);
      continue;
    }
    const Point2 first = o.polygon[0][0];
    areas[{number(o.y + first.y), number(o.x + first.x)}].own.push_back(i);
  }
  if (areas.empty()) areas[{0, 0}];  // so that there is a task, whose part says that nothing was found
  auto& first = areas.begin()->second.own;
  first.insert(first.end(), nowhere.begin(), nowhere.end());
  std::sort(first.begin(), first.end());
  const OutlineMap map = map_of_outlines(sites);
  const auto reach = static_cast<std::int64_t>(std::ceil(params.reach * kMillimetresPerMetre)) + 1;
  std::vector<AreaSites> cut;
  for (auto& [square, area] : areas) {
    area.area.row = square.first;
    area.area.column = square.second;
    area.area.sites = area.own.size();
    for (const std::size_t i : area.own) {
      if (sites[i].outline.polygon.empty()) continue;
      area.area.read.add_box(read_box(sites[i].outline.box, params.halo, step_metres));
      for (const std::uint32_t n : map.near(sites[i].outline.box.grown(reach))) area.neighbours.push_back(n);
    }
    std::sort(area.neighbours.begin(), area.neighbours.end());
    area.neighbours.erase(std::unique(area.neighbours.begin(), area.neighbours.end()), area.neighbours.end());
    std::erase_if(area.neighbours,
                  [&](std::size_t n) { return std::binary_search(area.own.begin(), area.own.end(), n); });
    cut.push_back(std::move(area));
  }
  return cut;
}

}  // namespace ilot
