// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/plane_methods/facade_direction.h"
#include "kernels/planes/plane_segments.h"

namespace ilot {

struct FacadeRansacParams {
  double epsilon = 0;  // units; greatest distance of a point from its plane [5 mm, 1 cm]
  double min_cos = 0;  // of the angle between normals of a point and its plane [0: not asked]
  double inclined_from = 0.3090169943749474, inclined_to = 0.9510565162951535;  // |Nz| of inclined points [18, 72 deg]
  double parallel_sine = 0.03141075907812829;  // greatest |a|, |c| of a plane parallel to the facade [1.8 deg]
  std::int64_t inclined_gap = 1;               // units; growing of inclined points [2 cm]
  std::uint32_t inclined_points = 1000;        // of an inclined segment; smaller ones go back to the pool
  std::uint32_t parallel_points = 3000;        // of a plane parallel to the facade
  std::int64_t connectivity = 1;               // units; of planes parallel to the facade
  double probability = 0.99;
  std::uint64_t key = 0;
};

// The parameters with angles in degrees, the tilt of a plane's normal out of the horizontal and out of the facade's.
FacadeRansacParams with_degrees(FacadeRansacParams params, double inclined_from, double inclined_to, double parallel);

// The numbers as Marchand 2018 wrote them, 0.2, 0.8 and 0.02: 11.5 to 53.1 and 1.15 degrees, although its text says 18
// to 72 and 1.8.
FacadeRansacParams with_raw_numbers(FacadeRansacParams params);

struct FacadeSegments {
  PlaneSegments segments;      // inclined planes first, then planes parallel to the facade
  std::uint32_t inclined = 0;  // how many of them are inclined
  FacadeDirection direction;
};

// Facade RANSAC [Marchand 2018, II.2.1.3]. Inclined surfaces first: points whose normal is inclined grow into segments
// by distance, and those of enough points are taken (as planes within epsilon, what they leave goes back). Then planes
// parallel to the facade: hypotheses that lean out of it are thrown away before they are counted. Planes level or
// across the facade are left alone on purpose: they would steal points along the edges of the stones. No upright
// points: no segments.
FacadeSegments facade_ransac(const OrientedPoints& points, const FacadeRansacParams& params);

}  // namespace ilot
