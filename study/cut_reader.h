// SPDX-License-Identifier: Apache-2.0
// A cloud without some of its points: those high above the ground, as some scans are cut for privacy or to save space,
// or all but a share of them.
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

// Returns a reader of one in `of` points of another reader, drawn at random by their number. The others are rejected.
std::unique_ptr<PointReader> thinned(std::unique_ptr<PointReader> reader, std::uint32_t of);

}  // namespace ilot
