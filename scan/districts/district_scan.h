// SPDX-License-Identifier: Apache-2.0
// The scene `district`: a town seen from the air. It is produced cell by cell.
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
  std::optional<std::uint64_t> points;  // the scan stops after exactly this number
};

// Makes the scan from options. If `points` is given, the area is chosen so that it gives that number of points at the
// density. If the area is set as well, the density is chosen instead. Throws Error (usage) when all three are given.
DistrictScan plan_district(const SceneValues& values, std::uint64_t seed, std::optional<std::uint64_t> points);

// One scanned cell that is ready to be written.
struct ScannedCell {
  Cell cell;
  std::uint32_t first_plane = 0,
                first_building = 0;  // ids: true_plane of the cell's plane 0; building of its house 0
  std::vector<std::byte> records;    // in the layout scan_layout()
};

// Scans the cells one after the other and passes each to `take`, in order. Cells are made in parallel, in batches of
// bounded size, on the threads of the calling arena. The result does not depend on the number of threads. Throws Error
// when ids or points run out: when there are more planes than 32 bits can number, or fewer points than requested.
void scan_district(const DistrictScan& scan, const std::function<void(const ScannedCell&)>& take);

}  // namespace ilot::scan
