// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/columns/stations_pass.h"
#include "engine/formats/reader.h"

namespace ilot {

// The opened inputs of a run, as passes and products are given them.
struct RunInputs {
  std::vector<std::unique_ptr<PointReader>> readers;  // by path
  Crs crs;                                            // of them all, one unit in all axes; what products are in
  std::uint64_t points = 0;
  std::vector<Station> stations;            // of the stations file, or else of the inputs
  std::vector<InputStations> row_stations;  // per reader: which of these its rows are from
};

}  // namespace ilot
