// SPDX-License-Identifier: Apache-2.0
// Tops of dormers, chimneys and other boxes on a roof that are too small for planes of their own.
#pragma once
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

// Adds level planes to the result of find_roof_planes. The neighbourhood of a point on a top of less than a square
// metre reaches beyond the top, so its normal is useless. But points without a plane that lie at one height, cover an
// area and hide everything below them are still a surface. A top has at least 5 points within epsilon of one height,
// each within two steps of another. Its convex hull contains at most a fifth as many other points. The hull covers a
// quarter or more of the area that this number of points stands for, since hits on a wall lie on a line. Tops with the
// most points are taken first (ties: by the first point). O(n log n) in points without a plane, as long as few of them
// lie within two steps of one another.
void add_level_tops(const RoofSite& site, RoofPlanes& planes);

}  // namespace ilot
