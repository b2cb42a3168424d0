// SPDX-License-Identifier: Apache-2.0
// The distance between neighbouring points on a plane: the diagonal of a cell of their raster. It decides which gaps
// are openings [Lorraine thesis, 3.3]. It is predicted from the stations of the scanner, or measured from the nearest
// neighbours.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/point2.h"

namespace ilot {

// A scanner that turns about its axis by azimuth_step between profiles, and by elevation_step between points of a
// profile. Steps are in radians, below 0.1.
struct Scanner {
  Vec3 position;
  Vec3 axis{0, 0, 1};  // of unit length
  double azimuth_step = 0;
  double elevation_step = 0;
};

// Returns the longer diagonal of the cell around p on the plane, for any plane and any tilt. The rays half a step to
// each side of the ray to p bound the cell. p is on the plane. The result is infinite where one of these rays does not
// meet the plane, and at the station.
double predicted_step(const Scanner& station, const Plane& plane, Vec3 p);

// Returns the smallest step of several stations, infinite without any.
double predicted_step(std::span<const Scanner> stations, const Plane& plane, Vec3 p);

// Returns the number of points per square unit that the station measures there: one per area of that cell. It is zero
// where there is no such cell.
double predicted_density(const Scanner& station, const Plane& plane, Vec3 p);

// Returns the sum over several stations, as if nothing stood between them and the plane.
double predicted_density(std::span<const Scanner> stations, const Plane& plane, Vec3 p);

// The formula of the document for a levelled scanner and a vertical plane, without the shear of the cell. It is too
// short by a quarter at 45 degrees to both sides. It is here for comparison.
double documented_step(const Scanner& station, const Plane& plane, Vec3 p);

// Returns the diagonal of a cell of the square raster that is as dense as a disc with k points. This is the step that
// the neighbours indicate.
double raster_step(double squared_radius, int k);

// Measured steps, and the distances that show whether they can be trusted.
struct MeasuredSteps {
  std::vector<float> step;           // per point, lattice units
  std::vector<std::int64_t> reach2;  // squared distance of the k-th neighbour, -1 when fewer lie within `farthest`
};

// Measures the step of each point from the k nearest other places (1 to 63) in the plane. It is the step of a square
// raster as dense as the disc that contains these places. On a square raster itself the error is within a tenth for k =
// 6. Points that coincide count once. Where fewer than k places are within `farthest`, the step is that of k points
// within it. The extent of the points must be below 2^24 lattice units, and `farthest` is at most 2^22.
MeasuredSteps measured_steps(std::span<const Point2> points, int k, std::int64_t farthest);

}  // namespace ilot
