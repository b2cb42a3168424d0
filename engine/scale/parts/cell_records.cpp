// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/cell_records.h"

#include <algorithm>
#include <filesystem>

#include "engine/error.h"
#include "engine/products/planes/cells/cell_shapes.h"
#include "engine/products/planes/cells/planes_pass.h"
#include "engine/scale/parts/record_bytes.h"

namespace ilot {
namespace {

using nlohmann::json;

// Empty where the store does not have the column.
template <class T>
std::vector<T> read_column_of(const Store& store, const Cell& cell, const Column<T>& column) {
  std::vector<T> values;
  if (!store.has(cell.slices.front().block, column)) return values;
  for (const CellSlice& s : cell.slices) {
    const std::vector<T> part = store.read(s.block, column, s.first, s.count);
    values.insert(values.end(), part.begin(), part.end());
  }
  return values;
}

std::vector<std::byte> content_of(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? read_column<std::byte>(path) : std::vector<std::byte>{};
}

}  // namespace

CellRecord read_cell(const Store& store, const Cell& cell) {
  return {cell.node,
          read_column_of(store, cell, columns::kCodes),
          read_column_of(store, cell, columns::kOrder),
          read_column_of(store, cell, columns::kClass),
          read_column_of(store, cell, columns::kNormals),
          read_column_of(store, cell, columns::kColour),
          read_column_of(store, cell, columns::kStation),
          read_column_of(store, cell, columns::kRole),
          content_of(cell_path(store, cell)),
          content_of(shapes_path(store, cell))};
}

json record_of(const CellRecord& cell) {
  const Tile tile = cell.node.tile;
  return {{"cell", {tile.x, tile.y, tile.z, cell.node.level, cell.node.first_code}},
          {"codes", bytes_json(cell.codes)},
          {"order", bytes_json(cell.order)},
          {"classes", bytes_json(cell.classes)},
          {"normals", bytes_json(cell.normals)},
          {"colours", bytes_json(cell.colours)},
          {"stations", bytes_json(cell.stations)},
          {"roles", bytes_json(cell.roles)},
          {"planes", bytes_json(cell.planes)},
          {"shapes", bytes_json(cell.shapes)}};
}

CellRecord cell_record(const json& record) {
  const json& place = record.at("cell");
  CellRecord r{{{place.at(0).get<std::int32_t>(), place.at(1).get<std::int32_t>(), place.at(2).get<std::int32_t>()},
                place.at(3).get<std::int32_t>(),
                place.at(4).get<std::uint64_t>()},
               values_of<std::uint64_t>(record, "codes"),
               values_of<InputOrder>(record, "order"),
               values_of<std::uint8_t>(record, "classes"),
               values_of<PackedNormal>(record, "normals"),
               values_of<StoredColour>(record, "colours"),
               values_of<StationNumber>(record, "stations"),
               values_of<PointRole>(record, "roles"),
               values_of<std::byte>(record, "planes"),
               values_of<std::byte>(record, "shapes")};
  const std::size_t points = r.codes.size();
  const auto fits = [points](const auto& values) { return values.empty() || values.size() == points; };
  const bool whole = points > 0 && r.order.size() == points && fits(r.classes) && fits(r.normals) && fits(r.colours) &&
                     fits(r.stations) && fits(r.roles) && r.normals.empty() == r.planes.empty();
  const bool inside = whole && r.node.level >= 0 && r.node.level <= kTileBits && std::ranges::is_sorted(r.codes) &&
                      r.codes.front() >= r.node.first_code && r.codes.back() <= r.node.last_code();
  if (!inside) throw Error("the fields of a cell do not belong together");
  return r;
}

}  // namespace ilot
