// SPDX-License-Identifier: Apache-2.0
// How high the parts of a sloping face lie.
#pragma once
#include "engine/model/building.h"

namespace ilot {

// Heights in CRS units. `half` and `seven_tenths` are those that this share of the face, as seen from above, does not
// exceed.
struct FaceHeights {
  double min = 0, half = 0, seven_tenths = 0, max = 0;
};

// Of a flat face that is not upright: its eaves are at `min` and its ridge at `max`. For a face without an area in plan
// all four are its lowest height. O(corners log corners).
FaceHeights face_heights(const Building& building, const BuildingSurface& surface);

}  // namespace ilot
