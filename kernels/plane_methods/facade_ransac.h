// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/plane_methods/facade_direction.h"
#include "kernels/planes/plane_segments.h"

namespace ilot {

struct FacadeRansacParams {
  double epsilon = 0;  // units; greatest distance of a point from its plane [5 mm, 1 cm]
  double min_cos = 0;  // of the angle between the normal of a point and that of its plane [0: not used]
  double inclined_from = 0.3090169943749474, inclined_to = 0.9510565162951535;  // |Nz| of inclined points [18, 72 deg]
  double parallel_sine = 0.03141075907812829;  // greatest |a|, |c| of a plane parallel to the facade [1.8 deg]
  std::int64_t inclined_gap = 1;               // units; largest gap when inclined points grow into segments [2 cm]
  std::uint32_t inclined_points = 1000;        // fewest of an inclined segment; points of smaller ones are free again
  std::uint32_t parallel_points = 3000;        // fewest points of a plane parallel to the facade
  std::int64_t connectivity = 1;               // units; of planes parallel to the facade
  double probability = 0.99;
  std::uint64_t key = 0;
};

// Returns the parameters for angles in degrees: the tilt of the normal of a plane out of the horizontal and out of the
// normal of the facade.
FacadeRansacParams with_degrees(FacadeRansacParams params, double inclined_from, double inclined_to, double parallel);

// Returns the parameters for the numbers as Marchand 2018 wrote them, 0.2, 0.8 and 0.02. These are 11.5 to 53.1 and
// 1.15 degrees, although the text says 18 to 72 and 1.8.
FacadeRansacParams with_raw_numbers(FacadeRansacParams params);

struct FacadeSegments {
  PlaneSegments segments;      // inclined planes first, then planes parallel to the facade
  std::uint32_t inclined = 0;  // how many of them are inclined
  FacadeDirection direction;
};

// Facade RANSAC [Marchand 2018, II.2.1.3]. Inclined surfaces come first: points with an inclined normal grow into
// segments by distance, and segments with enough points are taken as planes within epsilon. Points beyond epsilon are
// available again. Planes parallel to the facade come second: hypotheses that are not parallel to it are dropped before
// they are counted. Planes that are horizontal or perpendicular to the facade are left out on purpose, because they
// would take points along the edges of the stones. Without upright points there are no segments.
FacadeSegments facade_ransac(const OrientedPoints& points, const FacadeRansacParams& params);

}  // namespace ilot
