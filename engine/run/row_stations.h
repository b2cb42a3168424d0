// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "engine/columns/stations_pass.h"
#include "engine/formats/reader.h"

namespace ilot {

enum class StationsFrom : std::uint8_t { inputs, file };

// Which of the stations the rows of each input are from, as names and numbers tell it. Of the inputs' own stations
// (those of all readers one after the other) it is told by the reader. Of a stations file: all rows of a cloud are from
// the station that is called as the file (without folder and extension); else those of a scan in it from the station
// that is called as the scan, and those of a point_source_id from the one station that has it. No two stations may
// share a name or number that counts: then neither does. O(readers x stations).
std::vector<InputStations> row_stations(const std::vector<std::unique_ptr<PointReader>>& readers,
                                        std::span<const Station> stations, StationsFrom from);

}  // namespace ilot
