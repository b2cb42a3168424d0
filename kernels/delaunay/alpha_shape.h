// SPDX-License-Identifier: Apache-2.0
// Selects the triangles of a Delaunay triangulation that form the shape of its points [Marchand 2018, II.4.1; Lorraine
// thesis, 3.2; Boltcheva et al. 2019, 3.3.1], and divides them among blocks.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

// Derived: the circumradius of a sliver is many times its edges; four are those of an angle of 7 degrees.
constexpr double kRadiusPerEdge = 4;

// `reach` is per point, in lattice units, at least 0 [Lorraine thesis, 3.3]. The reach of a triangle is the largest of
// its corners. Where heights are given, in lattice units, the length of an edge is measured in space [D5 II]. Where
// labels are given, a triangle with corners of two labels is dropped [D5 III].
struct ShapeParams {
  TriangleRule rule = TriangleRule::kCircumradius;
  std::span<const float> reach;
  std::span<const std::int32_t> height = {};  // kLongestEdge only; within kMaxPlaneCoordinate
  std::span<const std::uint32_t> label = {};
};

// Returns for each triangle 1 when it belongs to the shape. Comparisons include equality. The result is the same for
// the same three positions up to a shift, whatever the order of the corners. O(n).
std::vector<std::uint8_t> shape_triangles(const Triangulation& t, std::span<const Point2> points,
                                          const ShapeParams& params);

// Returns the corner that owns a triangle: the one with the largest reach, and of equal ones the smallest in (x, y).
std::uint32_t owner(const Triangulation& t, std::size_t triangle, std::span<const Point2> points,
                    std::span<const float> reach);

// Returns how far around its own points a block has to look. Then each triangle of the shape that one of its points
// owns is the same as in the triangulation of all points. The circle of such a triangle is within twice the largest
// circumradius, which the reach of the owner bounds. `largest` is the largest reach of the block's own points.
std::int64_t shape_halo(TriangleRule rule, double largest);

// Returns for each point 1 when a block needs it. A block needs its own points, those within shape_halo() of the reach
// of one of its own, and some beside them. The reach of other points is not used. O(n).
std::vector<std::uint8_t> needed_points(TriangleRule rule, std::span<const Point2> points, std::span<const float> reach,
                                        std::span<const std::uint8_t> own);

// Returns the triangles to keep that the block's own points own, from a triangulation of these points and those that
// the block needs. `own` is 1 for each point of the block. Over all blocks each triangle of the whole shape is returned
// exactly once.
std::vector<std::uint32_t> owned_triangles(const Triangulation& t, std::span<const Point2> points,
                                           const ShapeParams& params, std::span<const std::uint8_t> own);

// Erosion from the outside only [Boltcheva et al. 2019, 3.3.1]. The function adds to the shape the dropped triangles
// that are not joined to the outside by a path across edges between dropped triangles. So holes stay closed. O(n).
void keep_enclosed(const Triangulation& t, std::span<std::uint8_t> keep);

}  // namespace ilot
