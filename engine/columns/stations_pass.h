// SPDX-License-Identifier: Apache-2.0
// Which station each point of the store was measured from, as the inputs tell it.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

using StationNumber = std::uint16_t;  // index + 1 into the run's stations; 0 = not told
constexpr std::size_t kMostNumberedStations = 65535;

// What the rows of one input say of their station.
struct InputStations {
  StationNumber of_all = 0;                          // every row's, when not 0
  std::map<std::uint16_t, StationNumber> of_source;  // by point_source_id; other ids say nothing
};

struct StationTally {
  std::uint64_t recorded = 0, unrecorded = 0;  // points of the store
};

// Writes the column "station" (StationNumber) of every block. `inputs` and `told` belong together. Inputs whose rows
// tell by point_source_id are read once more for that alone, into files of 2 bytes a row, so memory stays that of a
// block.
StationTally stations_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                           const std::vector<InputStations>& recorded, const PassContext& context);

}  // namespace ilot
