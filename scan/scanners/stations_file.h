// SPDX-License-Identifier: Apache-2.0
// NAME.stations.csv: where the scanners of a scene stood and how they turned, as `ilot run --stations` reads it.
#pragma once
#include <filesystem>
#include <span>

#include "scan/scanners/station.h"

namespace ilot::scan {

// NAME.stations.csv of NAME.las.
std::filesystem::path stations_path(const std::filesystem::path& cloud);

// World coordinates, degrees, a line a station. Whole or not at all. Throws Error.
void write_stations(const std::filesystem::path& path, std::span<const StationParams> stations);

}  // namespace ilot::scan
