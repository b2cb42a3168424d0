// SPDX-License-Identifier: Apache-2.0
// A cloud without what is high above the ground, as scans that were cut for one's privacy or for the sake of size are.
#pragma once
#include <memory>

#include "engine/formats/reader.h"

namespace ilot {

// a x + b y + c z + d = 0 in the units of the cloud.
struct CutPlane {
  double a = 0, b = 0, c = 1, d = 0;
};

// The points of another reader, those more than `height` above the plane rejected.
std::unique_ptr<PointReader> cut_above(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height);

}  // namespace ilot
