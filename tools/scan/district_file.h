// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

#include "tools/scan/district_scan.h"

namespace ilot::scan {

struct ScanSummary {
  std::uint64_t points = 0, buildings = 0, planes = 0;  // planes with the ground
};

// Scans the district into a LAS file and its truth into NAME.truth.json beside it. Both appear whole or not
// at all. Memory does not grow with the area. Throws Error.
ScanSummary write_district(const DistrictScan& scan, const std::filesystem::path& path);

// NAME.truth.json of NAME.las.
std::filesystem::path truth_path(const std::filesystem::path& cloud);

}  // namespace ilot::scan
