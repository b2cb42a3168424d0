// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/stations_pass.h"

#include <array>

#include "engine/cloud/record.h"
#include "engine/columns/row_values.h"
#include "engine/formats/fields.h"

namespace ilot {
namespace {

std::uint16_t source_of(std::span<const std::byte> record, const RecordLayout& layout) {
  return decode_fields(record, layout.point_format).source_id;
}

// A table for each file by source id, so that the lookup for a point is fast.
std::vector<std::vector<StationNumber>> tables_of(const std::vector<InputStations>& recorded) {
  std::vector<std::vector<StationNumber>> tables;
  for (const InputStations& input : recorded) {
    tables.emplace_back(input.of_source.empty() ? 0 : std::size_t{1} << 16, StationNumber{0});
    for (const auto& [source, station] : input.of_source) tables.back()[source] = station;
  }
  return tables;
}

// An input with only one station need not be read: the number of its file is enough.
void gather_by_file(const Store& store, const std::vector<InputStations>& recorded, const Column<StationNumber>& column,
                    const PassContext& context) {
  constexpr std::uint64_t kBytesPerPoint = 10;
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    const auto order = store.read(block, columns::kOrder);
    auto values = store.has(block, column) ? store.read(block, column) : std::vector<StationNumber>(order.size(), 0);
    for (std::size_t p = 0; p < order.size(); ++p)
      if (const StationNumber all = recorded[file_of(order[p])].of_all) values[p] = all;
    store.write(block, column, values);
  });
}

StationTally count(const Store& store, const PassContext& context) {
  std::vector<StationTally> tallies(store.blocks().size());
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * sizeof(StationNumber), b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    for (const StationNumber s : store.read(static_cast<std::uint32_t>(i), columns::kStation))
      ++(s != 0 ? tallies[i].recorded : tallies[i].unrecorded);
  });
  StationTally all;
  for (const StationTally& t : tallies) all = {all.recorded + t.recorded, all.unrecorded + t.unrecorded};
  return all;
}

}  // namespace

StationTally stations_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                           const std::vector<InputStations>& recorded, const PassContext& context) {
  const std::vector<std::vector<StationNumber>> tables = tables_of(recorded);
  const RowValues<std::uint16_t> rows(store, "sources", inputs, [&](std::size_t file) {
    return recorded[file].of_all == 0 && !recorded[file].of_source.empty();
  });
  if (!rows.empty()) {
    rows.read(kFieldSource, context, source_of, [](std::uint16_t&, std::uint16_t) {});
    rows.gather(columns::kStation, StationNumber{0}, context,
                [&](std::uint16_t source, std::size_t file) { return tables[file][source]; });
  }
  if (std::any_of(recorded.begin(), recorded.end(), [](const InputStations& input) { return input.of_all != 0; }) ||
      rows.empty())
    gather_by_file(store, recorded, columns::kStation, context);
  return count(store, context);
}

}  // namespace ilot
