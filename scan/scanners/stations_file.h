// SPDX-License-Identifier: Apache-2.0
// NAME.stations.csv: the positions and directions of the scanners of a scene, in the format that `ilot run --stations`
// reads.
#pragma once
#include <filesystem>
#include <span>

#include "scan/scanners/scan_record.h"
#include "scan/scanners/station.h"

namespace ilot::scan {

// Returns NAME.stations.csv for NAME.las.
std::filesystem::path stations_path(const std::filesystem::path& cloud);

// Writes world coordinates and degrees, one line per station. The file is written whole or not at all. Throws Error.
void write_stations(const std::filesystem::path& path, std::span<const StationParams> stations,
                    Vec3 origin = kSceneOrigin);

}  // namespace ilot::scan
