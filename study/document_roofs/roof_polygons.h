// SPDX-License-Identifier: Apache-2.0
// Boltcheva's polygons of a graph [Boltcheva et al. 2019, 3.3.3] and their projection onto the planes of their faces
// [Boltcheva et al. 2019, 3.3.4].
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"
#include "study/document_roofs/roof_graph.h"

namespace ilot::bench {

constexpr double kPlanar = 0.01;  // metres; a vertex within this distance of its planes is on them

enum class Walk { kByVertex, kByEdge };

struct FacePolygon {
  std::uint32_t label = 0;
  std::vector<std::uint32_t> corners;
  bool closed = false;
};

// Algorithm 4: makes one polygon for each label that at least one vertex has.
std::vector<FacePolygon> polygons_of(const Graph& g, std::uint32_t labels, Walk walk);

// Returns twice the area in plan in square millimetres. Returns 0 for a polygon that is degenerate or touches itself.
double area_of(const FacePolygon& p, const std::vector<Vec3>& at);

// Returns whether no polygon is open or degenerate.
bool all_closed(const Graph& g, const std::vector<FacePolygon>& polygons);

// Fits a plane by least squares through the points of each label.
std::vector<Plane> planes_of(const LabelledRoof& b);

enum class Fault { kNone, kParallel, kMoved, kNotPlanar, kCrossed };

// Returns the first fault of the polygons after every vertex was moved onto the planes of its faces: planes without a
// common point, a vertex that moved by `move` metres or more in plan, a vertex off its planes, a polygon that turned
// over or touches itself.
Fault projected(const Graph& g, const std::vector<FacePolygon>& polygons, const std::vector<Plane>& planes,
                double move);

}  // namespace ilot::bench
