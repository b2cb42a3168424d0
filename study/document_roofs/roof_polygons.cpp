// SPDX-License-Identifier: Apache-2.0
#include "study/document_roofs/roof_polygons.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/eigen3.h"
#include "kernels/outlines/simple_ring.h"

namespace ilot::bench {

namespace {

constexpr std::uint32_t kNowhere = 0xffffffffu;

Plane best_plane(const std::vector<Vec3>& points) {
  Vec3 centre;
  for (const Vec3& p : points) centre = centre + p;
  centre = (1.0 / static_cast<double>(points.size())) * centre;
  Symmetric3 s;
  for (const Vec3& p : points) {
    const Vec3 d = p - centre;
    s.xx += d.x * d.x;
    s.xy += d.x * d.y;
    s.xz += d.x * d.z;
    s.yy += d.y * d.y;
    s.yz += d.y * d.z;
    s.zz += d.z * d.z;
  }
  const Vec3 n = eigen_symmetric(s).vectors[0];
  return {n, -dot(n, centre)};
}

// Finds the point where three planes meet. Returns false where their normals lie in one plane.
bool meet(const Plane& a, const Plane& b, const Plane& c, Vec3& at) {
  constexpr double kSingular = 1e-9;
  const double det = dot(a.n, cross(b.n, c.n));
  if (std::abs(det) < kSingular) return false;
  at = (-1 / det) * (a.d * cross(b.n, c.n) + b.d * cross(c.n, a.n) + c.d * cross(a.n, b.n));
  return true;
}

// [Boltcheva et al. 2019, 3.3.4] Projects a corner onto one plane, onto the line of two planes, or onto the point of
// three planes.
bool project(const std::vector<Plane>& of_label, const Corner& c, Vec3& at) {
  const Plane& a = of_label[c.labels[0]];
  at = c.at - signed_distance(a, c.at) * a.n;
  if (c.labels.size() == 1) return true;
  const Plane& b = of_label[c.labels[1]];
  if (c.labels.size() > 2) return meet(a, b, of_label[c.labels[2]], at);
  const Vec3 along = cross(a.n, b.n);
  const double length = norm(along);
  if (length == 0) return false;
  const Vec3 n = (1 / length) * along;
  return meet(a, b, {n, -dot(n, c.at)}, at);
}

}  // namespace

std::vector<FacePolygon> polygons_of(const Graph& g, std::uint32_t labels, Walk walk) {
  std::vector<FacePolygon> result;
  std::vector<std::uint8_t> used(labels + 1);
  for (std::uint32_t s = 0; s < g.corners.size(); ++s)
    for (const std::uint32_t label : g.corners[s].labels) {
      if (used[label] != 0) continue;
      used[label] = 1;
      const auto may = [&](const Link& l) {
        return g.corners[l.to].has(label) && (walk == Walk::kByVertex || l.has(label));
      };
      FacePolygon p{label, {s}, false};
      std::vector<std::uint8_t> visited(g.corners.size());
      visited[s] = 1;
      for (std::uint32_t at = s; at != kNowhere;) {
        std::uint32_t next = kNowhere;
        for (const Link& l : g.links[at])
          if (next == kNowhere && visited[l.to] == 0 && may(l)) next = l.to;
        if (next != kNowhere) {
          visited[next] = 1;
          p.corners.push_back(next);
        }
        at = next;
      }
      for (const Link& l : g.links[p.corners.back()]) p.closed = p.closed || (l.to == s && may(l));
      p.closed = p.closed && p.corners.size() >= 3;
      result.push_back(std::move(p));
    }
  return result;
}

double area_of(const FacePolygon& p, const std::vector<Vec3>& at) {
  std::vector<Point2> ring;
  for (const std::uint32_t c : p.corners) ring.push_back(place_of(at[c]));
  return is_simple_ring(ring) ? static_cast<double>(doubled_area(ring)) : 0;
}

Fault projected(const Graph& g, const std::vector<FacePolygon>& polygons, const std::vector<Plane>& planes,
                double move) {
  std::vector<Vec3> before, after;
  std::vector<std::uint8_t> wanted(g.corners.size());
  for (const FacePolygon& p : polygons)
    for (const std::uint32_t c : p.corners) wanted[c] = 1;
  bool moved = false, planar = true;
  for (std::size_t i = 0; i < g.corners.size(); ++i) {
    const Corner& c = g.corners[i];
    before.push_back(c.at);
    after.push_back(c.at);
    if (wanted[i] == 0) continue;
    if (!project(planes, c, after.back())) return Fault::kParallel;
    const Vec3 d = after.back() - c.at;
    moved = moved || !(plan_dot(d, d) < move * move);
    for (const std::uint32_t label : c.labels)
      planar = planar && std::abs(signed_distance(planes[label], after.back())) <= kPlanar;
  }
  if (moved) return Fault::kMoved;
  if (!planar) return Fault::kNotPlanar;
  for (const FacePolygon& p : polygons)
    if (area_of(p, before) * area_of(p, after) <= 0) return Fault::kCrossed;
  return Fault::kNone;
}

std::vector<Plane> planes_of(const LabelledRoof& b) {
  std::vector<std::vector<Vec3>> members(b.labels + 1);
  for (std::size_t i = 0; i < b.points.size(); ++i) members[b.label[i]].push_back(b.points[i]);
  std::vector<Plane> planes(members.size());
  for (std::size_t l = 1; l < members.size(); ++l)
    if (!members[l].empty()) planes[l] = best_plane(members[l]);
  return planes;
}

bool all_closed(const Graph& g, const std::vector<FacePolygon>& polygons) {
  std::vector<Vec3> at;
  for (const Corner& c : g.corners) at.push_back(c.at);
  return !polygons.empty() && std::all_of(polygons.begin(), polygons.end(),
                                          [&](const FacePolygon& p) { return p.closed && area_of(p, at) != 0; });
}

}  // namespace ilot::bench
