// SPDX-License-Identifier: Apache-2.0
// Boltcheva's polygons of a graph [Boltcheva et al. 2019, 3.3.3] and their projection onto the planes of their faces
// [Boltcheva et al. 2019, 3.3.4].
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"
#include "study/document_roofs/roof_graph.h"

namespace ilot::bench {

constexpr double kPlanar = 0.01;  // metres from its planes within which a vertex lies on them

enum class Walk { kByVertex, kByEdge };

struct FacePolygon {
  std::uint32_t label = 0;
  std::vector<std::uint32_t> corners;
  bool closed = false;
};

// Algorithm 4: one polygon for each label that some vertex has.
std::vector<FacePolygon> polygons_of(const Graph& g, std::uint32_t labels, Walk walk);

// Twice the area in plan in square millimetres, 0 for what is degenerate or touches itself.
double area_of(const FacePolygon& p, const std::vector<Vec3>& at);

// No polygon is open or degenerate.
bool all_closed(const Graph& g, const std::vector<FacePolygon>& polygons);

// Least squares through the points of each label.
std::vector<Plane> planes_of(const LabelledRoof& b);

enum class Fault { kNone, kParallel, kMoved, kNotPlanar, kCrossed };

// The first fault of the polygons once every vertex is on the planes of its faces: planes without a common point, a
// vertex moved by `move` metres or more in plan, one off its planes, a polygon that turned over or touches itself.
Fault projected(const Graph& g, const std::vector<FacePolygon>& polygons, const std::vector<Plane>& planes,
                double move);

}  // namespace ilot::bench
