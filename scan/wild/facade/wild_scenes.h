// SPDX-License-Identifier: Apache-2.0
// The wild scenes of facades: facade-wild, row-wild and court-wild.
#pragma once
#include <array>
#include <string_view>

#include "scan/scenes.h"
#include "scan/wild/facade/wild_file.h"
#include "scan/wild/facade/wild_scanner.h"

namespace ilot::scan {

// The groups of distributions.csv that each scene draws from.
inline constexpr std::array<std::string_view, 4> kFacadeWildGroups{"scanner", "site", "facade", "single"};
inline constexpr std::array<std::string_view, 4> kRowWildGroups{"scanner", "site", "facade", "row"};
inline constexpr std::array<std::string_view, 4> kCourtWildGroups{"scanner", "site", "facade", "court"};

WildScan plan_facade_wild(const SceneValues& values, std::uint64_t seed);
WildScan plan_row_wild(const SceneValues& values, std::uint64_t seed);
WildScan plan_court_wild(const SceneValues& values, std::uint64_t seed);

// Makes the entry of a wild scene in the table of scenes from the function that plans it.
template <WildScan (*plan)(const SceneValues& values, std::uint64_t seed)>
ScanCounts scan_wild_scene(const ScanRequest& request) {
  return write_wild(plan(request.values, request.seed), request);
}

}  // namespace ilot::scan
