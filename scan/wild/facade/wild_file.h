// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/wild/facade/wild_scanner.h"

namespace ilot::scan {

constexpr std::uint64_t kMostWildPoints = 2'000'000;  // of a scan without --points

// Fits the density, scans, and writes the cloud, its truth with all that was drawn and, where the stations are known,
// their file. Each file is written whole or not at all. Throws Error.
ScanCounts write_wild(WildScan scan, const ScanRequest& request);

}  // namespace ilot::scan
