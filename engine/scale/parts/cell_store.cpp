// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/cell_store.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/pass/index.h"
#include "engine/pass/pass.h"
#include "engine/products/planes/cells/cell_shapes.h"
#include "engine/products/planes/cells/planes_pass.h"
#include "engine/scale/parts/cell_records.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/parts/roof_label_records.h"
#include "engine/scale/plan_products.h"
#include "engine/scale/records.h"
#include "engine/scale/site_records.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// Derived: a cell of kCellPoints points takes 9 MB as a record, and is there up to six times while it is unpacked.
constexpr std::uint64_t kBytesToUnpack = std::uint64_t{54} << 20;

constexpr const char* kNormalsOfCell = ".normals";
constexpr const char* kColoursOfCell = ".colours";
constexpr const char* kStationsOfCell = ".stations";
constexpr const char* kRolesOfCell = ".roles";

fs::path carried(const Store& store, const Node& node, const char* suffix) {
  return store.folder() / "carried" / (node.name() + suffix);
}

// The points of the cell go to the run, all else to files of its own. `inputs` are those of its area. Sets
// `any_stations` where the cell has stations.
void unpack_cell(const CellRecord& r, std::span<const std::uint32_t> inputs, const Plan& plan, const Store& store,
                 SortedRunWriter& run, std::atomic<bool>& any_stations) {
  const auto known = [&](StationNumber station) { return station <= plan.stations.size(); };
  if (!std::ranges::all_of(r.stations, known))
    throw Error("a cell of a part names a station that the plan does not have");
  std::vector<KeyValue> points(r.codes.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t place = file_of(r.order[i]);
    if (place >= inputs.size()) throw Error("a cell of a part names an input that its area does not have");
    const std::uint8_t code = r.classes.empty() ? std::uint8_t{0} : r.classes[i];
    points[i] = {r.codes[i], run_value(input_order(inputs[place], row_of(r.order[i])), code, 0)};
  }
  run.add(r.node.tile, points);
  const Cell cell{r.node, 0, {}};
  const auto keep = [&]<class T>(const std::filesystem::path& path, const std::vector<T>& values) {
    if (!values.empty()) write_column<T>(path, values);
    return !values.empty();
  };
  keep(carried(store, r.node, kNormalsOfCell), r.normals);
  keep(carried(store, r.node, kColoursOfCell), r.colours);
  keep(carried(store, r.node, kRolesOfCell), r.roles);
  if (keep(carried(store, r.node, kStationsOfCell), r.stations)) any_stations = true;
  keep(shapes_path(store, cell), r.shapes);
  keep(cell_path(store, cell), r.planes);
}

// What parts have of roofs goes to files of its own, which are read when the buildings have their numbers.
struct RoofRecords {
  RecordFileWriter buildings, labels;

  RoofRecords(const fs::path& folder, const std::string& area, const nlohmann::json& head)
      : buildings(folder / kBuildingsOfParts / area, head), labels(folder / kLabelsOfParts / area, head) {}

  // Whether the record is one of roofs.
  bool take(const nlohmann::json& record) {
    if (is_placed_labels(record))
      labels.add(record);
    else if (is_building(record) || is_summary(record))
      buildings.add(record);
    else
      return false;
    return true;
  }
  void finish() {
    buildings.finish();
    labels.finish();
  }
};

SortedRun unpack_part(const fs::path& part, std::span<const std::uint32_t> inputs, const Plan& plan, const Store& store,
                      const fs::path& stem, std::atomic<bool>& any_stations, const PassContext& context) {
  SortedRunWriter run(stem);
  RecordFileReader file(part);
  std::optional<RoofRecords> roofs;
  if (makes_roofs(plan)) roofs.emplace(store.folder(), part.filename().string(), file.head());
  std::optional<Node> last;
  try {
    while (const auto record = file.next()) {
      stop_if_asked();
      if (roofs ? roofs->take(*record) : is_summary(*record)) continue;
      const CellRecord cell = cell_record(*record);
      if (last && !(before(*last, cell.node) && !last->contains(cell.node)))
        throw Error(part.string() + ": its cells are not in order");
      last = cell.node;
      unpack_cell(cell, inputs, plan, store, run, any_stations);
      context.advance(cell.codes.size());
    }
  } catch (const nlohmann::json::exception&) {
    throw Error(part.string() + ": is damaged; remove it and run its task again");
  }
  if (roofs) roofs->finish();
  return run.finish();
}

// Writes a column of all blocks from the files of the cells; `none` where a cell has no file.
template <class T>
void spread(const Store& store, const std::vector<Cell>& cells, const Column<T>& column, const char* suffix, T none,
            const PassContext& context) {
  const auto pieces = pieces_of_blocks(store, cells);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * sizeof(T), b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    std::vector<T> values(store.blocks()[block].points, none);
    for (const CellPiece& p : pieces[block]) {
      const fs::path path = carried(store, cells[p.cell].node, suffix);
      if (!fs::exists(path)) continue;
      ColumnReader<T>(path).read(p.offset, std::span(values).subspan(p.slice.first, p.slice.count));
    }
    store.write(block, column, values);
  });
}

// `suffix` is of a column of type T that every cell has.
template <class T>
void check_cells(const Store& store, const std::vector<Cell>& cells, const char* suffix) {
  for (const Cell& cell : cells) {
    const fs::path values = carried(store, cell.node, suffix);
    if (!fs::exists(values) || ColumnReader<T>(values).size() != cell.points)
      throw Error("the parts do not have the cells of one run; remove them and run the tasks again");
  }
}

void spread_all(const Store& store, const Plan& plan, bool any_stations, const PassContext& context) {
  const std::vector<Cell> cells = canonical_cells(store, context.metres_per_unit);
  if (makes_roofs(plan)) {
    check_cells<PointRole>(store, cells, kRolesOfCell);
    spread(store, cells, columns::kRole, kRolesOfCell, PointRole::unclassified, context);
  }
  if (!searches_planes(plan)) return;
  check_cells<PackedNormal>(store, cells, kNormalsOfCell);
  spread(store, cells, columns::kNormals, kNormalsOfCell, PackedNormal{}, context);
  // As in a run, whose drawings are coloured where an input has colours, even if none of its points is used.
  if (reads_colours(plan)) spread(store, cells, columns::kColour, kColoursOfCell, kNoColour, context);
  if (any_stations) spread(store, cells, columns::kStation, kStationsOfCell, StationNumber{0}, context);
}

}  // namespace

Store store_of_parts(const fs::path& parts, std::span<const std::uint64_t> areas, const Plan& plan,
                     std::uint64_t block_points, const fs::path& folder, const PassContext& context) {
  for (const char* name : {"runs", "blocks", "cells", "carried", kBuildingsOfParts, kLabelsOfParts})
    fs::create_directories(folder / name);
  const Store empty(folder, plan.lattice.unit, {});
  std::vector<SortedRun> runs(areas.size());
  std::atomic<bool> any_stations = false;
  run_pass(std::vector<PassTask>(areas.size(), {kBytesToUnpack, 1}), context.budget_bytes, [&](std::size_t i) {
    runs[i] = unpack_part(parts / std::to_string(areas[i]), plan.areas[areas[i] - 1].inputs, plan, empty,
                          folder / "runs" / std::to_string(i), any_stations, context);
  });
  IndexParams params;
  params.block_points = block_points;
  if (carries_class_codes(plan)) params.classes = ClassColumns::written;
  Store store(folder, plan.lattice.unit, build_blocks(runs, params, {}, folder, context));
  fs::remove_all(folder / "runs");
  if (searches_planes(plan) || makes_roofs(plan)) spread_all(store, plan, any_stations, context);
  fs::remove_all(folder / "carried");
  return store;
}

}  // namespace ilot
