// SPDX-License-Identifier: Apache-2.0
// A cloud without its points high above the ground. Some scans are cut in this way for privacy or to save space.
#pragma once
#include <memory>

#include "engine/formats/reader.h"

namespace ilot {

// The plane a x + b y + c z + d = 0 in the units of the cloud.
struct CutPlane {
  double a = 0, b = 0, c = 1, d = 0;
};

// Returns a reader of the points of another reader. Points more than `height` above the plane are rejected.
std::unique_ptr<PointReader> cut_above(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height);

}  // namespace ilot
