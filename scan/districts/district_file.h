// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>

#include "scan/districts/district_scan.h"
#include "scan/scenes.h"

namespace ilot::scan {

struct ScanSummary {
  std::uint64_t points = 0, buildings = 0, planes = 0;  // planes: the ground is counted too
};

// Scans the district into a LAS file. Writes its truth into NAME.truth.json and its houses into NAME.truth.city.jsonl
// in the same folder. No file is left half-written. Memory does not grow with the area. `written` is called with the
// count of points as they are written. Throws Error.
ScanSummary write_district(const DistrictScan& scan, const std::filesystem::path& path,
                           const std::function<void(std::uint64_t)>& written = {});

// Does the same from options. This is the entry in the table of scenes.
ScanCounts scan_district_scene(const ScanRequest& request);

}  // namespace ilot::scan
