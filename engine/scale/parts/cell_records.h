// SPDX-License-Identifier: Apache-2.0
// The cells of a task as records: the points of a cell, and everything that was found in it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "engine/columns/colours_pass.h"
#include "engine/columns/point_roles.h"
#include "engine/columns/stations_pass.h"
#include "engine/products/planes/cells/cells.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

// One value of each list for each point, in global order. Lists that the products of the plan do not need are empty.
struct CellRecord {
  Node node;
  std::vector<std::uint64_t> codes;
  std::vector<InputOrder> order;      // with places in the list of inputs of the area
  std::vector<std::uint8_t> classes;  // class codes of the inputs
  std::vector<PackedNormal> normals;
  std::vector<StoredColour> colours;    // empty where no input of the area has colours
  std::vector<StationNumber> stations;  // empty where no input of the area has them in its rows
  std::vector<PointRole> roles;
  std::vector<std::byte> planes;  // the content of cell_path()
  std::vector<std::byte> shapes;  // the content of shapes_path(); empty where there is none
};

// Reads a cell with all that its store has of it.
CellRecord read_cell(const Store& store, const Cell& cell);

nlohmann::json record_of(const CellRecord& cell);

// Throws nlohmann::json::exception where a field is missing, and Error where the lists do not belong together.
CellRecord cell_record(const nlohmann::json& record);

}  // namespace ilot
