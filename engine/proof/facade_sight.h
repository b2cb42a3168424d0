// SPDX-License-Identifier: Apache-2.0
// Which share of the edges and faces of a facade's plan no station could see.
#pragma once
#include <span>

#include "engine/model/facade.h"
#include "engine/visibility/line_of_sight.h"

namespace ilot {

struct FacadeSightParams {
  double margin_m = 0.015;  // before what is looked at, that a line of sight may end: what is measured is no better
  double edge_spacing_m = 0.04;  // of places along an edge, 4 to 64 of them
  double metres_per_unit = 1;
};

// Lines of sight from every station (CRS) to places along each edge and across each face; a face is seen from the side
// that it looks to alone. What stands between them are `faces`: planes of the whole cloud and the elements of its
// facades, this one's too. Shares are of places, to a thousandth. Fills `occluded_share` of the edges and faces there
// are (FacadeProof::write makes faces); nothing without stations. In parallel over elements. O(places x stations)
// lines.
void measure_sight(std::span<const Vec3> stations, const LineOfSight& faces, const FacadeSightParams& params,
                   Facade& facade);

}  // namespace ilot
