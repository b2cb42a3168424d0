// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/roofs/solids/roof_solid.h"

namespace ilot {

// Choice: what 3DBAG asks of its models, less what rounding to tenths of a millimetre may add.
constexpr double kMostBent = 0.0009;  // metres

// Into what a bent face is divided: few planar pieces, or triangles, which are planar whatever their corners.
enum class Division { pieces, triangles };

// Divides each roof face of which a corner is farther than `most_bent` from the least squares plane of its corners. The
// parts keep the number of the face. The solid stays closed. Returns whether a face was divided. O(n^2) in the corners
// of such a face for each part.
bool divide_bent_faces(RoofSolid& solid, Division how, double most_bent = kMostBent);

}  // namespace ilot
