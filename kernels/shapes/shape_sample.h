// SPDX-License-Identifier: Apache-2.0
// Shapes through the fewest points with normals that determine them [A6, Schnabel, Wahl and Klein 2007]. Normals have
// no side: PCA gives lines, not arrows. Nothing where the points do not determine a shape well.
#pragma once
#include <array>
#include <optional>

#include "kernels/shapes/shape.h"

namespace ilot {

struct OrientedPoint {
  Vec3 p, n;  // n unit
};
using ShapeSample = std::array<OrientedPoint, 3>;

std::optional<Shape> plane_through(const ShapeSample& s);     // its three points
std::optional<Shape> sphere_through(const ShapeSample& s);    // two points: where their normals come nearest
std::optional<Shape> cylinder_through(const ShapeSample& s);  // two points: axis across both normals
std::optional<Shape> cone_through(const ShapeSample& s);      // three tangent planes meet in the apex

// The shape of that kind, if all three points lie within epsilon of it and their normals agree with it.
std::optional<Shape> sample_shape(ShapeKind kind, const ShapeSample& s, double epsilon, double min_cos);

}  // namespace ilot
