// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/columns/stations_pass.h"
#include "engine/formats/reader.h"
#include "engine/model/edit.h"

namespace ilot {

// What drawings say of an input.
struct InputSource {
  std::string name;  // of its file
  std::string date;  // file_date()
};

// The opened inputs of a run, for passes and products.
struct RunInputs {
  std::vector<std::unique_ptr<PointReader>> readers;  // by path
  Crs crs;  // the same for all inputs, with one unit in all axes; products use it too
  std::uint64_t points = 0;
  std::vector<InputSource> sources;         // of each input
  std::vector<Station> stations;            // from the stations file, or else from the inputs
  std::vector<InputStations> row_stations;  // for each reader, the stations of its rows
  std::vector<Edit> edits;                  // corrections by hand, in the order in which they are made
};

}  // namespace ilot
