// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "engine/columns/stations_pass.h"
#include "engine/formats/reader.h"

namespace ilot {

enum class StationsFrom : std::uint8_t { inputs, file };

// Finds the station of the rows of each input, from names and numbers. The inputs' own stations (those of all readers
// one after the other) are assigned by their reader. For a stations file: all rows of a cloud are from the station with
// the name of the file (without folder and extension). Otherwise the rows of a scan in it are from the station with the
// name of the scan, and the rows of a point_source_id are from the one station that has this number. If two stations
// have the same name or number, it is used for neither. O(readers x stations).
std::vector<InputStations> row_stations(const std::vector<std::unique_ptr<PointReader>>& readers,
                                        std::span<const Station> stations, StationsFrom from);

}  // namespace ilot
