// SPDX-License-Identifier: Apache-2.0
// Shapes through the fewest points with normals that determine them [A6, Schnabel, Wahl and Klein 2007]. Normals have
// no sign, because PCA gives lines and not arrows. The result is empty where the points do not determine a shape well.
#pragma once
#include <array>
#include <optional>

#include "kernels/shapes/shape.h"

namespace ilot {

struct OrientedPoint {
  Vec3 p, n;  // n is a unit vector
};
using ShapeSample = std::array<OrientedPoint, 3>;

std::optional<Shape> plane_through(const ShapeSample& s);     // through its three points
std::optional<Shape> sphere_through(const ShapeSample& s);    // two points: where their normals are nearest
std::optional<Shape> cylinder_through(const ShapeSample& s);  // two points; the axis is perpendicular to both normals
std::optional<Shape> cone_through(const ShapeSample& s);      // three points; their tangent planes meet in the apex

// Returns the shape of that kind if all three points are within epsilon of it and their normals agree with it.
std::optional<Shape> sample_shape(ShapeKind kind, const ShapeSample& s, double epsilon, double min_cos);

}  // namespace ilot
