// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/cell_part.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/columns/normals_pass.h"
#include "engine/pass/pass.h"
#include "engine/products/planes/cells/planes_pass.h"
#include "engine/products/roofs/roof_roles.h"
#include "engine/scale/parts/cell_records.h"
#include "engine/scale/plan_products.h"

namespace ilot {

std::int64_t halo_of_cells(const Plan& plan, double unit_metres) {
  const auto steps = [&](double metres) { return static_cast<std::int64_t>(std::ceil(metres / unit_metres)) + 2; };
  std::int64_t halo = 0;
  if (searches_planes(plan)) {
    const int bits = std::bit_width(static_cast<std::uint64_t>(largest_cell(unit_metres))) - 1;
    const Cell largest{{{}, kTileBits - bits, 0}, 0, {}};
    halo = margin_of(largest) + steps(plan.settings.normals.max_radius);
  }
  if (carries_roof_labels(plan) && plan.roofs.by_shape)
    halo = std::max(halo, steps(reach_of_found_roles(plan.settings)));
  return halo;
}

std::uint64_t write_cells(const Store& store, const RunInputs& inputs, const Plan& plan, const PlanArea& area,
                          const PassContext& context, Progress& progress, RecordFileWriter& part) {
  if (store.points() == 0) return 0;
  const bool planes = searches_planes(plan);
  if (planes) {
    progress.begin_stage("normals", store.points());
    normals_pass(store, plan.settings.normals, context);
  }
  std::vector<Cell> cells = canonical_cells(store, context.metres_per_unit);
  std::erase_if(cells, [&](const Cell& cell) { return !area.own.contains(cell.node.min_corner()); });
  std::uint64_t points = 0;
  for (const Cell& cell : cells) points += cell.points;
  progress.begin_stage("cells", points);
  if (planes) planes_pass(store, cells, settings_of_cells(plan), context);
  if (carries_colours(plan, area)) colours_pass(store, inputs.readers, context);
  if (carries_stations(plan, area)) stations_pass(store, inputs.readers, inputs.row_stations, context);
  progress.end_stage();
  for (const Cell& cell : cells) {
    stop_if_asked();
    CellRecord record = read_cell(store, cell);
    if (!planes) record.normals.clear();                     // found for roles alone
    if (!carries_class_codes(plan)) record.classes.clear();  // read for roles alone
    part.add(record_of(record));
  }
  return cells.size();
}

}  // namespace ilot
