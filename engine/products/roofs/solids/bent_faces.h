// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/roofs/solids/roof_solid.h"

namespace ilot {

// Choice: what 3DBAG asks of its models, less what rounding to tenths of a millimetre may add.
constexpr double kMostBent = 0.0009;  // metres

// Divides each roof face of which a corner is farther than this from the least squares plane of its corners into
// triangles, which are planar whatever their corners. They keep the number of the face. The solid stays closed. Returns
// whether a face was divided. O(n log n) in corners.
bool divide_bent_faces(RoofSolid& solid, double most_bent = kMostBent);

}  // namespace ilot
