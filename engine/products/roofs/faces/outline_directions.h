// SPDX-License-Identifier: Apache-2.0
// The directions of a building's sides.
#pragma once
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"
#include "kernels/geometry/flat.h"

namespace ilot {

struct WeightedDirection {
  double weight = 0;  // metres of sides
  FlatPoint along;    // unit length; its opposite is the same direction
};

// Adds a direction of any length but 0. It adds its weight to the first known one within 3 degrees, else it is new.
void add_direction(FlatPoint along, double weight, std::vector<WeightedDirection>& directions);

// Returns the directions of the sides of the outline, those of the longest sides first, and across each of them with
// half of its weight. O(sides x directions).
std::vector<WeightedDirection> outline_directions(const SitePolygon& outline);

}  // namespace ilot
