// SPDX-License-Identifier: Apache-2.0
// Which station each point of the store was measured from, as recorded in the inputs.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

using StationNumber = std::uint16_t;  // index + 1 into the stations of the run; 0 = not recorded
constexpr std::size_t kMostNumberedStations = 65535;

// What the rows of one input record about their station.
struct InputStations {
  StationNumber of_all = 0;                          // the station of every row, when not 0
  std::map<std::uint16_t, StationNumber> of_source;  // by point_source_id; other ids have no station
};

struct StationTally {
  std::uint64_t recorded = 0, unrecorded = 0;  // numbers of points of the store
};

// Writes the column "station" (StationNumber) of every block. `inputs` and `recorded` are parallel lists; where
// `inputs` is empty, the stations that rows record by point_source_id are those that the column has already. An input
// whose rows record the station by point_source_id is read once more for this, into files of 2 bytes per row. Therefore
// the memory is that of one block.
StationTally stations_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                           const std::vector<InputStations>& recorded, const PassContext& context);

}  // namespace ilot
