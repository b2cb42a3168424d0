// SPDX-License-Identifier: Apache-2.0
// Computes the share of each edge and face of a facade's plan that no station could see.
#pragma once
#include <span>

#include "engine/model/facade.h"
#include "engine/visibility/line_of_sight.h"

namespace ilot {

struct FacadeSightParams {
  double margin_m = 0.015;  // a line of sight may end this far before its target: measurements are no more accurate
  double edge_spacing_m = 0.04;  // metres between places along an edge; 4 to 64 places
  double metres_per_unit = 1;
};

// Tests lines of sight from every station (CRS) to places along each edge and across each face. A face is seen only
// from the side to which it looks. `faces` can block a line: they are the planes of the whole cloud and the elements of
// its facades, including this one. Shares are shares of places, to a thousandth. Fills `occluded_share` of the existing
// edges and faces (FacadeProof::write makes the faces). Without stations nothing is written. Parallel over elements.
// O(places x stations) lines.
void measure_sight(std::span<const Vec3> stations, const LineOfSight& faces, const FacadeSightParams& params,
                   Facade& facade);

}  // namespace ilot
