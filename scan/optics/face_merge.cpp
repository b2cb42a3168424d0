// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/face_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "kernels/geometry/ring.h"

namespace ilot::scan {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Ring = std::vector<std::uint32_t>;

// Returns a value that increases from 0 to 4 while b turns clockwise from a through a full turn.
double clockwise_turn(FlatPoint a, FlatPoint b) {
  const double sine = b.x * a.y - b.y * a.x, cosine = a.x * b.x + a.y * b.y;
  const double share = sine / (std::abs(sine) + std::abs(cosine));
  if (cosine < 0) return 2 - share;
  return share < 0 ? 4 + share : share;
}

// Returns the edges of the patches of a plane that no neighbour of the same plane cancels. For each vertex it is the
// set of vertices to which these edges lead.
std::map<std::uint32_t, std::set<std::uint32_t>> border_of(std::span<const Patch> patches, std::uint32_t plane) {
  std::set<Edge> edges;
  for (const Patch& patch : patches) {
    if (patch.plane != plane) continue;
    for (std::size_t i = 0; i < patch.ring.size(); ++i) {
      const std::uint32_t from = patch.ring[i], to = patch.ring[(i + 1) % patch.ring.size()];
      if (edges.erase({to, from}) == 0) edges.insert({from, to});
    }
  }
  std::map<std::uint32_t, std::set<std::uint32_t>> ways;
  for (const auto& [from, to] : edges) ways[from].insert(to);
  return ways;
}

// Returns the vertex whose edge stays closest to the inside, among those to which edges lead.
std::uint32_t tightest(const std::set<std::uint32_t>& ways, std::uint32_t from, std::uint32_t at,
                       std::span<const Vec3> vertices, Vec3 normal) {
  if (ways.size() == 1) return *ways.begin();
  const FlatPoint here = flatten(vertices[at], normal);
  const auto towards = [&](std::uint32_t v) {
    const FlatPoint f = flatten(vertices[v], normal);
    return FlatPoint{f.x - here.x, f.y - here.y};
  };
  const FlatPoint back = towards(from);
  return *std::min_element(ways.begin(), ways.end(), [&](std::uint32_t a, std::uint32_t b) {
    return clockwise_turn(back, towards(a)) < clockwise_turn(back, towards(b));
  });
}

std::vector<Ring> chain(std::map<std::uint32_t, std::set<std::uint32_t>> ways, std::span<const Vec3> vertices,
                        Vec3 normal) {
  std::vector<Ring> rings;
  while (!ways.empty()) {
    const std::uint32_t start = ways.begin()->first;
    Ring ring{start};
    std::uint32_t from = start, at = *ways.begin()->second.begin();
    const auto leave = [&](std::uint32_t vertex, std::uint32_t to) {
      ways[vertex].erase(to);
      if (ways[vertex].empty()) ways.erase(vertex);
    };
    leave(from, at);
    while (at != start) {
      ring.push_back(at);
      const std::uint32_t next = tightest(ways.at(at), from, at, vertices, normal);
      leave(at, next);
      from = std::exchange(at, next);
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

std::vector<FlatPoint> flatten_ring(const Ring& ring, std::span<const Vec3> vertices, Vec3 normal) {
  std::vector<FlatPoint> flat;
  for (std::uint32_t v : ring) flat.push_back(flatten(vertices[v], normal));
  return flat;
}

// Makes one face per outline. Each hole belongs to the smallest outline around it.
std::vector<MergedFace> sort_rings(std::vector<Ring> rings, std::uint32_t plane, std::span<const Vec3> vertices,
                                   Vec3 normal) {
  std::vector<MergedFace> faces;
  std::vector<std::vector<FlatPoint>> outlines;
  std::vector<Ring> holes;
  for (Ring& ring : rings) {
    std::vector<FlatPoint> flat = flatten_ring(ring, vertices, normal);
    if (doubled_area(flat) < 0) {
      holes.push_back(std::move(ring));
      continue;
    }
    faces.push_back({plane, {std::move(ring)}});
    outlines.push_back(std::move(flat));
  }
  for (Ring& hole : holes) {
    const FlatPoint place = flatten(vertices[hole[0]], normal);
    std::size_t around = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const double area = doubled_area(outlines[f]);
      if (area < least && contains_by_share(outlines[f], place)) {
        around = f;
        least = area;
      }
    }
    faces[around].rings.push_back(std::move(hole));
  }
  return faces;
}

bool straight(Vec3 before, Vec3 at, Vec3 after) {
  const Vec3 in = at - before, out = after - at;
  return norm(cross(in, out)) < 1e-9 * norm(in) * norm(out) && dot(in, out) > 0;
}

}  // namespace

FlatPoint flatten(Vec3 p, Vec3 normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (z >= x && z >= y) return normal.z > 0 ? FlatPoint{p.x, p.y} : FlatPoint{p.y, p.x};
  if (x >= y) return normal.x > 0 ? FlatPoint{p.y, p.z} : FlatPoint{p.z, p.y};
  return normal.y > 0 ? FlatPoint{p.z, p.x} : FlatPoint{p.x, p.z};
}

std::vector<MergedFace> merge_patches(std::span<const Patch> patches, std::span<const Vec3> vertices,
                                      std::span<const Plane> planes) {
  std::vector<MergedFace> faces;
  for (std::uint32_t plane = 0; plane < planes.size(); ++plane) {
    const Vec3 normal = planes[plane].n;
    std::vector<Ring> rings = chain(border_of(patches, plane), vertices, normal);
    for (MergedFace& face : sort_rings(std::move(rings), plane, vertices, normal)) faces.push_back(std::move(face));
  }
  return faces;
}

void drop_straight_vertices(std::vector<MergedFace>& faces, std::span<const Vec3> vertices) {
  std::vector<bool> corner(vertices.size());
  const auto for_each_vertex = [&](const auto& visit) {
    for (MergedFace& face : faces)
      for (Ring& ring : face.rings) visit(ring);
  };
  for_each_vertex([&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i)
      if (!straight(vertices[ring[(i + n - 1) % n]], vertices[ring[i]], vertices[ring[(i + 1) % n]]))
        corner[ring[i]] = true;
  });
  for_each_vertex([&](Ring& ring) { std::erase_if(ring, [&](std::uint32_t v) { return !corner[v]; }); });
}

}  // namespace ilot::scan
