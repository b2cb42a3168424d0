// SPDX-License-Identifier: Apache-2.0
// Which triangles of a Delaunay triangulation make up the shape of its points [Marchand 2018, II.4.1; Lorraine
// thesis, 3.2; Boltcheva et al. 2019, 3.3.1], and how blocks share them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/delaunay/delaunay.h"

namespace ilot {

constexpr double kRadiusPerEdge = 4;

// reach: per point, in lattice units, at least 0 [Lorraine thesis, 3.3]; a triangle takes the largest of its corners'.
// An edge's length is the one in space where heights are given, in lattice units [D5 II]. Where labels are given, a
// triangle with corners of two labels is dropped [D5 III].
struct ShapeParams {
  TriangleRule rule = TriangleRule::kCircumradius;
  std::span<const float> reach;
  std::span<const std::int32_t> height = {};  // kLongestEdge only; within kMaxPlaneCoordinate
  std::span<const std::uint32_t> label = {};
};

// Per triangle 1 when it belongs to the shape. Comparisons are closed, and the same for the same three positions up to
// a shift, whatever the order of the corners. O(n).
std::vector<std::uint8_t> shape_triangles(const Triangulation& t, std::span<const Point2> points,
                                          const ShapeParams& params);

// The corner that a triangle belongs to: the one with the largest reach, of equals the smallest in (x, y).
std::uint32_t owner(const Triangulation& t, std::size_t triangle, std::span<const Point2> points,
                    std::span<const float> reach);

// How far around its own points a block has to look, so that each triangle of the shape that one of them owns comes out
// as in the triangulation of all points: the circle lies within twice the largest circumradius, which the owner's reach
// bounds. `largest`: the largest reach of the block's own points.
std::int64_t shape_halo(TriangleRule rule, double largest);

// Per point 1 when a block needs it: its own points, those within shape_halo() of the reach of one of its own, and some
// beside them. The reach of other points is not looked at. O(n).
std::vector<std::uint8_t> needed_points(TriangleRule rule, std::span<const Point2> points, std::span<const float> reach,
                                        std::span<const std::uint8_t> own);

// Of a triangulation of a block's own points and those it needs the triangles to keep that its own points own.
// own: per point, 1 = of the block. Over all blocks each triangle of the whole shape is given exactly once.
std::vector<std::uint32_t> owned_triangles(const Triangulation& t, std::span<const Point2> points,
                                           const ShapeParams& params, std::span<const std::uint8_t> own);

// Erosion from the outside only [Boltcheva et al. 2019, 3.3.1]: adds to the shape the triangles that no path over edges
// between dropped triangles joins to the outside, so that holes stay shut. O(n).
void keep_enclosed(const Triangulation& t, std::span<std::uint8_t> keep);

}  // namespace ilot
