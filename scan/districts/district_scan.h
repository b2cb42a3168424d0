// SPDX-License-Identifier: Apache-2.0
// The scene `district`: a town seen from the air, streamed cell by cell.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "scan/districts/district.h"
#include "scan/scanners/airborne.h"
#include "scan/scene_options.h"

namespace ilot::scan {

struct DistrictScan {
  DistrictParams district;
  AirborneParams flight;
  double noise = 0.02;                  // metres
  std::optional<std::uint64_t> points;  // stop after exactly so many
};

// From options. With `points`, the area is chosen to hold them at the density; where the area is set as well,
// the density is. Throws Error (usage) when all three are given.
DistrictScan plan_district(const SceneValues& values, std::uint64_t seed, std::optional<std::uint64_t> points);

// One scanned cell, ready to be written.
struct ScannedCell {
  Cell cell;
  std::uint32_t first_plane = 0,
                first_building = 0;  // ids: true_plane of the cell's plane 0; building of its house 0
  std::vector<std::byte> records;    // of scan_layout()
};

// Scans cell after cell and hands each over, in order. Cells are made in parallel, a batch of bounded size at
// a time, on the threads of the calling arena; what is handed over does not depend on their number. Throws
// Error when ids or points run out: more planes than 32 bits, or fewer points than asked for.
void scan_district(const DistrictScan& scan, const std::function<void(const ScannedCell&)>& take);

}  // namespace ilot::scan
