// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_areas.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "engine/pass/pass.h"

namespace ilot {
namespace {

constexpr double kMillimetresPerMetre = 1000;
// Choice: smaller than the halo of any product, so that the estimate of points is not far off.
constexpr double kSquareMetres = 16;  // greatest side of a square in which points are counted
constexpr std::uint64_t kBytesToMap = 24;
// Choice: a task of some minutes; larger ones lose more when a worker dies, smaller ones read more halo.
constexpr double kPointsOfArea = 10e6;
// Choice: halos are then at most half of what is read.
constexpr double kLeastHalos = 5;  // side of an area in halos
constexpr double kRoundTo = 10;    // metres

using Chunk = std::pair<std::uint32_t, std::size_t>;  // input, and number in it

// The points of one block: in squares, and the boxes of those of each chunk.
struct BlockMap {
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint64_t> squares;
  std::map<Chunk, IndexBox> chunks;
};

BlockMap map_of_block(const Store& store, std::uint32_t block, std::span<const ChunkBoxes> inputs, int bits) {
  BlockMap map;
  const auto codes = store.read(block, columns::kCodes);
  const auto orders = store.read(block, columns::kOrder);
  const Tile tile = store.blocks()[block].node.tile;
  std::pair<std::int64_t, std::int64_t> last;
  std::uint64_t* count = nullptr;
  Chunk last_chunk;
  IndexBox* box = nullptr;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const Index3 p = index_of({tile, codes[i]});
    const std::uint32_t file = file_of(orders[i]);
    const Chunk chunk{file, inputs[file].chunk_of(row_of(orders[i]))};
    if (box == nullptr || chunk != last_chunk)
      box = &map.chunks.try_emplace(last_chunk = chunk, IndexBox::none()).first->second;
    box->add(p);
    const std::pair square{p.y >> bits, p.x >> bits};
    if (count == nullptr || square != last) count = &map.squares[last = square];
    ++*count;
  }
  return map;
}

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

std::uint64_t PointMap::in(const IndexBox& box) const {
  if (box.is_empty()) return 0;
  std::uint64_t points = 0;
  for (std::int64_t row = box.min.y >> bits; row <= box.max.y >> bits; ++row) {
    auto it = squares.lower_bound({row, box.min.x >> bits});
    for (; it != squares.end() && it->first <= std::pair{row, box.max.x >> bits}; ++it) points += it->second;
  }
  return points;
}

PointMap map_points(const Store& store, std::vector<ChunkBoxes> chunks, const PassContext& context) {
  int bits = 0;
  while (bits < kTileBits && std::ldexp(store.unit() * context.metres_per_unit, bits + 1) <= kSquareMetres) ++bits;
  PointMap all{bits, {}, std::move(chunks)};
  std::mutex adding;
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesToMap, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const BlockMap part = map_of_block(store, static_cast<std::uint32_t>(i), all.inputs, bits);
    const std::lock_guard lock(adding);
    for (const auto& [square, points] : part.squares) all.squares[square] += points;
    for (const auto& [chunk, box] : part.chunks) all.inputs[chunk.first].boxes[chunk.second].add_box(box);
  });
  return all;
}

double suitable_area_size(const PointMap& map, double step_metres, double halo) {
  std::uint64_t points = 0;
  for (const auto& [square, count] : map.squares) points += count;
  const double side = std::ldexp(step_metres, map.bits);
  const double occupied = side * side * static_cast<double>(std::max<std::size_t>(1, map.squares.size()));
  const double size = std::sqrt(kPointsOfArea * occupied / static_cast<double>(std::max<std::uint64_t>(1, points)));
  return std::ceil(std::max(size, kLeastHalos * halo) / kRoundTo) * kRoundTo;
}

std::vector<PlanArea> cut_cell_areas(const PointMap& map, const CellAreaParams& params) {
  const std::int64_t side = params.cell * params.cells;
  std::set<std::pair<std::int64_t, std::int64_t>> squares;
  for (const auto& [square, points] : map.squares)
    squares.emplace(square_of(square.first << map.bits, side), square_of(square.second << map.bits, side));
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
  std::vector<GridBox> boxes;
  for (const PlannedSite& site : sites) boxes.push_back(site.outline.polygon.empty() ? GridBox{} : site.outline.box);
  const OutlineMap map(std::move(boxes));
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
