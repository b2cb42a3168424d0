// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>

#include "tools/scan/district_scan.h"

namespace ilot::scan {

struct ScanSummary {
  std::uint64_t points = 0, buildings = 0, planes = 0;  // planes with the ground
};

// Scans the district into a LAS file and its truth into NAME.truth.json beside it. Neither stays
// half-written. Memory does not grow with the area. `written` hears of points as they are written. Throws
// Error.
ScanSummary write_district(const DistrictScan& scan, const std::filesystem::path& path,
                           const std::function<void(std::uint64_t)>& written = {});

// NAME.truth.json of NAME.las.
std::filesystem::path truth_path(const std::filesystem::path& cloud);

}  // namespace ilot::scan
