// SPDX-License-Identifier: Apache-2.0
// The Delaunay triangulation of points of a plane, and the shape that they cover (alpha shape).
//
//   const ilot::AlphaShape shape = ilot::alpha_shape(x, y, {.reach = 1.5});
//   std::printf("%zu polygons, %g m2\n", shape.polygons.size(), shape.area);
//
// Points are rounded to a lattice around the middle of their box, 2^30 steps along its longer side; all decisions are
// exact from there on. `step` = 0: the smallest 1, 2 or 5 times a power of ten that is fine enough, so 1e-6 up to 1 km.
// Functions own nothing and keep nothing; several threads may call them at once. They run on all threads that the
// process may use, and no result depends on how many these are. Error (usage) for arrays of different lengths, values
// that are not finite, or a step that is too fine.
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ilot {

constexpr std::uint32_t kNoEdge = 0xffffffffu;

// Triangle t has the corners corner[3t], corner[3t+1], corner[3t+2], which turn left. Edge e runs from corner[e] to the
// next corner of its triangle; twin[e] is the same edge seen from the neighbouring triangle, kNoEdge on the hull.
struct Triangulation {
  std::vector<std::uint32_t> corner;
  std::vector<std::uint32_t> twin;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates;  // (point left out, the smaller index it equals)
  std::size_t triangles() const { return corner.size() / 3; }
};

// Unique: points on one circle are decided by a rule that depends on nothing but them. No triangles when all points lie
// on a line. O(n log n); about 170 bytes of working memory a point; at most 2^29 points.
Triangulation delaunay(std::span<const double> x, std::span<const double> y, double step = 0);

enum class TriangleRule {
  kCircumradius,  // circumradius <= reach
  kLongestEdge,   // longest edge <= reach, and circumradius <= 4 reach: a sliver's circle has no bound
};

struct AlphaShapeOptions {
  double reach = 0;  // units of the coordinates, above 0
  TriangleRule rule = TriangleRule::kCircumradius;
  bool fill_holes = false;  // only gaps that the outside reaches are left out
  double step = 0;          // of the lattice; 0 = chosen
};

// A polygon: rings of indices of points, its outer ring counter-clockwise, then its holes clockwise. Rings are not
// closed by a repeated point; they touch in points, but never cross.
using ShapePolygon = std::vector<std::vector<std::uint32_t>>;

struct AlphaShape {
  std::vector<ShapePolygon> polygons;
  double area = 0;  // squared units, holes taken off
};

// The triangles that are kept, joined over edges. Empty where no triangle is. O(n log n).
AlphaShape alpha_shape(std::span<const double> x, std::span<const double> y, const AlphaShapeOptions& options);

}  // namespace ilot
