// SPDX-License-Identifier: Apache-2.0
// How far apart the points on a plane are, the diagonal of a cell of their raster: what decides which gaps are openings
// [Lorraine thesis, 3.3]. Predicted from the scanner's stations, or else measured from the nearest neighbours.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// A scanner that turns about its axis by azimuth_step between profiles, and in each profile by elevation_step between
// points. Steps in radians, below 0.1.
struct Scanner {
  Vec3 position;
  Vec3 axis{0, 0, 1};  // of unit length
  double azimuth_step = 0;
  double elevation_step = 0;
};

// The longer diagonal of the cell that the rays half a step to each side of the one to p cut out of the plane, for any
// plane and any tilt. p lies on the plane. Infinite where one of these rays does not meet it, and at the station.
double predicted_step(const Scanner& station, const Plane& plane, Vec3 p);

// With several stations the smallest; infinite without any.
double predicted_step(std::span<const Scanner> stations, const Plane& plane, Vec3 p);

// Points per square unit that the station puts there: one on the area of that cell. Zero where there is no such cell.
double predicted_density(const Scanner& station, const Plane& plane, Vec3 p);

// Of several stations the sum, as if nothing stood between them and the plane.
double predicted_density(std::span<const Scanner> stations, const Plane& plane, Vec3 p);

// The document's formula for a levelled scanner and a vertical plane, without the cell's shear: short by a quarter at
// 45 degrees to both sides. For comparison.
double documented_step(const Scanner& station, const Plane& plane, Vec3 p);

// The diagonal of a cell of the square raster that is as dense as a disc of k points: the step that neighbours tell.
double raster_step(double squared_radius, int k);

// A measured step, and whether it can be trusted.
struct MeasuredSteps {
  std::vector<float> step;           // per point, lattice units
  std::vector<std::int64_t> reach2;  // squared distance of the k-th neighbour, -1 when fewer lie within `farthest`
};

// Per point from the k nearest other places (1 to 63) in the plane: that of a square raster as dense as the disc that
// holds them; on the raster itself within a tenth for k = 6. Points that coincide count once. Where fewer than k lie
// within `farthest`, the step is that of k points within it. The points' extent must be below 2^24 lattice units;
// `farthest` at most 2^22.
MeasuredSteps measured_steps(std::span<const Point2> points, int k, std::int64_t farthest);

}  // namespace ilot
