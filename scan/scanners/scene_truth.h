// SPDX-License-Identifier: Apache-2.0
// The truth of a terrestrial scene, with the counts of points by truth.
#pragma once
#include "scan/scanners/echo_point.h"
#include "scan/scanners/terrestrial.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

// Writes everything that the scene says about itself.
void write_scene_truth(TruthWriter& truth, const TerrestrialScene& scene, const BeamParams& beam,
                       const PointTally& tally);

// Returns the counts of points, planes, shapes, elements, and of points by class.
ScanCounts scene_counts(const TerrestrialScene& scene, const PointTally& tally);

}  // namespace ilot::scan
