// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_face.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/validity/ring_relations.h"
#include "kernels/meshes/predicates3.h"
#include "kernels/outlines/simple_ring.h"

namespace ilot {
namespace {

bool has_equal_neighbours(const std::vector<std::uint32_t>& ring) {
  return ring.front() == ring.back() || std::adjacent_find(ring.begin(), ring.end()) != ring.end();
}

bool triangle_has_area(const LatticeVertices& v, const std::vector<std::uint32_t>& ring) {
  return widest_axis({v.points[ring[0]], v.points[ring[1]], v.points[ring[2]]}) >= 0;
}

// A fault 104 of an inner ring does not stop the check: it goes on with the valid rings.
Faults validate_flat(std::vector<std::vector<Point2>> flat) {
  if (!is_simple_ring(flat[0])) return {{104, "outer ring"}};
  Faults faults;
  for (std::size_t r = flat.size() - 1; r > 0; --r) {
    if (is_simple_ring(flat[r])) continue;
    faults.push_back({104, fmt::format("inner ring {}", r)});
    flat.erase(flat.begin() + static_cast<std::ptrdiff_t>(r));
  }
  const bool left = doubled_area(flat[0]) > 0;
  for (std::size_t r = 1; r < flat.size(); ++r) {
    if ((doubled_area(flat[r]) > 0) != left) continue;
    faults.push_back({208, fmt::format("inner ring {}", r)});
    return faults;
  }
  if (flat.size() > 1)
    if (const int code = ring_relation_fault(flat)) faults.push_back({code, ""});
  return faults;
}

}  // namespace

Faults validate_face(const LatticeVertices& vertices, const FaceRings& rings, const ValidityParams& params) {
  const auto too_short = [](const auto& ring) { return ring.size() < 3; };
  if (rings.empty() || std::any_of(rings.begin(), rings.end(), too_short)) return {{101, ""}};
  if (std::any_of(rings.begin(), rings.end(), has_equal_neighbours)) return {{102, ""}};
  if (is_one_triangle(rings)) {
    if (triangle_has_area(vertices, rings[0])) return {};
    return {{104, "a triangle on a line"}};
  }
  const FacePlane plane = plane_of(vertices, rings);
  const double farthest = farthest_from(plane, vertices, rings);
  if (farthest > params.plane_distance) return {{203, fmt::format("{:.3f} from the plane", farthest)}};
  return validate_flat(flattened(plane, vertices, rings));
}

double least_normals_cosine(const LatticeVertices& vertices, std::span<const TriangleCorners> triangles) {
  double least = 1;
  Vec3 first;
  for (const TriangleCorners& t : triangles) {
    const Index3 a = vertices.points[t[0]];
    const Vec3 n = cross(offset(vertices, t[1], a), offset(vertices, t[2], a));
    if (!(norm(n) > 0)) continue;
    const Vec3 unit = (1 / norm(n)) * n;
    if (norm(first) == 0)
      first = unit;
    else
      least = std::min(least, dot(first, unit));
  }
  return least;
}

}  // namespace ilot
