// SPDX-License-Identifier: Apache-2.0
// Counts of points by truth, and the truth of a terrestrial scene with these counts.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/scanners/scan_record.h"
#include "scan/scanners/terrestrial.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

// Counts points per class, per plane and per element, by id.
struct Tally {
  std::vector<std::uint64_t> planes, elements, classes = std::vector<std::uint64_t>(256);
  std::uint64_t points = 0;

  void add(const RecordTruth& truth);
  static std::uint64_t of(const std::vector<std::uint64_t>& list, std::uint32_t id) {
    return id < list.size() ? list[id] : 0;
  }
};

// Writes everything that the scene says about itself.
void write_scene_truth(TruthWriter& truth, const TerrestrialScene& scene, const BeamParams& beam, const Tally& tally);

// Returns the counts of points, planes, shapes, elements, and of points by class.
ScanCounts scene_counts(const TerrestrialScene& scene, const Tally& tally);

}  // namespace ilot::scan
