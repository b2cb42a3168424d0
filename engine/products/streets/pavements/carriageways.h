// SPDX-License-Identifier: Apache-2.0
// Carriageways: the areas of road between kerbs.
#pragma once
#include <span>
#include <vector>

#include "ilot/streets.h"

namespace ilot {

struct CarriagewayParams {
  double spacing = 1;    // metres of kerb between two ways across
  double nearest = 0.5;  // metres; another kerb that is nearer is the same one
  double widest = 30;    // metres across
  // Choice: as far as kerbs are continued where they were not seen, and as widths of pavements confirm each other.
  double longest_gap = 12;   // metres of kerb without a kerb on the other side, between two ways of the same length
  double same_length = 0.3;  // metres
  double least_length = 3;   // metres of kerb; two steps of the ground that face each other for less are chance
  // Derived: what lies between two places cannot be told, so a smaller hole is no island.
  double least_hole = 1;    // square metres
  double tolerance = 0.02;  // metres that a corner may lie off; half of the error of kerbs in plan
};

// From each place on a kerb a way leads straight across the road to the first kerb that has its pavement on the far
// side. Between consecutive ways the area is road, as deep as both of them go; the carriageways are the union of these
// areas from both sides, and islands are their holes. Where the other side has no kerb, or none was found, there is no
// carriageway. Kerbs have their pavement on the left and are in the CRS, as are the rings. Ordered by their lowest x,
// numbered from 1. O(kerb log kerb + kerb carriageways).
std::vector<Carriageway> find_carriageways(std::span<const StreetKerb> kerbs, double metres_per_unit,
                                           const CarriagewayParams& params = {});

}  // namespace ilot
