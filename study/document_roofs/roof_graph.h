// SPDX-License-Identifier: Apache-2.0
// Boltcheva's mesh, contour and lines between faces [D5 to D7]: a graph in which each corner has the labels of its
// faces.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/delaunay/delaunay.h"
#include "study/document_roofs/labelled_roof.h"

namespace ilot::bench {

struct Mesh {
  Triangulation t;
  std::vector<std::uint8_t> keep;  // per triangle
  bool kept(std::uint32_t edge) const { return edge != kNoEdge && keep[edge / 3] != 0; }
  bool on_border(std::uint32_t edge) const { return kept(edge) && !kept(t.twin[edge]); }
};

enum class Distance { kPlan, kSpace };  // versions I and II of the document's erosion

// Removes triangles from the outside while their border edge is longer than alpha, in metres.
Mesh eroded(const std::vector<Vec3>& points, double alpha, Distance distance);

// Returns the dot product in plan.
inline double plan_dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y;
}

struct Corner {
  Vec3 at;
  std::vector<std::uint32_t> labels;  // of the faces it belongs to
  std::uint32_t after = 0;            // next corner along the border
  std::uint32_t border_edge = kNoEdge;
  bool junction() const { return labels.size() > 1; }
  bool has(std::uint32_t label) const { return std::find(labels.begin(), labels.end(), label) != labels.end(); }
};

struct Link {
  std::uint32_t to = 0;
  std::uint32_t labels[2]{};  // labels of the faces on its two sides; a link of the border has the same label twice
  bool has(std::uint32_t label) const { return labels[0] == label || labels[1] == label; }
};

struct Graph {
  std::vector<Corner> corners;
  std::vector<std::vector<Link>> links;
  void join(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) {
    links[a].push_back({b, {left, right}});
    links[b].push_back({a, {left, right}});
  }
};

// Returns the border of the mesh, smoothed and thinned (Algorithms 1 to 3, one corner within the radius, in metres),
// and the lines between faces. The graph is empty where the border has fewer than three corners.
Graph graph_of(const Mesh& m, const LabelledRoof& b, double radius);

}  // namespace ilot::bench
