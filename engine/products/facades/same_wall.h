// SPDX-License-Identifier: Apache-2.0
// How near two facades are that show one wall.
#pragma once

namespace ilot {

// Choice: the value that joins facades side by side (10 degrees).
constexpr double kOneWallCosine = 0.985;  // of the angle between two facades of one wall, at least
// Choice: the reveals of usual walls with what stands before them; a loggia is deeper.
constexpr double kOneWallDepth = 0.3;  // metres between the planes of two facades of one wall, at most

}  // namespace ilot
