// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "scan/roofs/roof_solid.h"

namespace ilot::scan {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
// For each directed edge, the vertex from which its face comes.
using EdgeMap = std::map<Edge, std::uint32_t>;

// Returns nothing when a directed edge occurs twice or a face meets itself.
std::optional<EdgeMap> edges_of(const RoofSolid& solid) {
  EdgeMap edges;
  for (const RoofFace& face : solid.faces) {
    std::set<std::uint32_t> met;
    for (const auto& ring : face.rings) {
      const std::size_t n = ring.size();
      if (n < 3) return std::nullopt;
      for (std::size_t i = 0; i < n; ++i) {
        if (!met.insert(ring[i]).second) return std::nullopt;
        if (!edges.insert({{ring[i], ring[(i + 1) % n]}, ring[(i + n - 1) % n]}).second) return std::nullopt;
      }
    }
  }
  return edges;
}

// Returns whether the faces around every vertex form one fan.
bool one_fan_per_vertex(const EdgeMap& edges) {
  auto first = edges.begin();
  while (first != edges.end()) {
    const std::uint32_t vertex = first->first.first;
    std::size_t ways = 0;
    auto end = first;
    for (; end != edges.end() && end->first.first == vertex; ++end) ++ways;
    std::size_t fan = 0;
    std::uint32_t to = first->first.second;
    do {
      to = edges.at({vertex, to});
      ++fan;
    } while (to != first->first.second && fan <= ways);
    if (fan != ways) return false;
    first = end;
  }
  return true;
}

bool closed(const EdgeMap& edges) {
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.first.second, e.first.first}) == 1;
  });
}

double perimeter(const RoofSolid& solid, const RoofFace& face) {
  double length = 0;
  for (const auto& ring : face.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      length += norm(solid.vertices[ring[(i + 1) % ring.size()]] - solid.vertices[ring[i]]);
  return length;
}

}  // namespace

std::optional<std::string_view> fault_of(const RoofSolid& solid, double least_edge, double least_width) {
  const std::optional<EdgeMap> edges = edges_of(solid);
  if (!edges) return "a face meets itself or an edge has more than two faces";
  if (!closed(*edges)) return "an edge is open";
  if (!one_fan_per_vertex(*edges)) return "faces touch in a point only";
  for (std::size_t i = 0; i < solid.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (norm(solid.vertices[i] - solid.vertices[j]) < least_edge) return "two vertices are too close";
  for (const RoofFace& face : solid.faces)
    if (face.part == RoofPart::roof && 2 * face_area(solid, face) < least_width * perimeter(solid, face))
      return "a roof face is too narrow";
  return std::nullopt;
}

}  // namespace ilot::scan
