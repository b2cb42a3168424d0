// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_neighbours.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/union_find.h"

namespace ilot::scan {
namespace {

constexpr double kSameNormal = 0.966;  // cosine of 15 degrees
constexpr double kClearStep = 0.4;     // metres between nearly parallel faces
constexpr double kSamePlace = 1e-6;    // metres
constexpr double kNear = 0.5;          // metres between boxes of faces that could be in almost one plane

Box3<Vec3> box_of(const RoofSolid& solid, const RoofFace& face) {
  const Vec3 first = solid.vertices[face.rings[0][0]];
  Box3<Vec3> box{first, first};
  for (std::uint32_t v : face.rings[0]) {
    const Vec3 p = solid.vertices[v];
    box.add(p);
  }
  return box;
}

bool near_each_other(const Box3<Vec3>& a, const Box3<Vec3>& b, double by) {
  return a.min.x <= b.max.x + by && b.min.x <= a.max.x + by && a.min.y <= b.max.y + by && b.min.y <= a.max.y + by &&
         a.min.z <= b.max.z + by && b.min.z <= a.max.z + by;
}

struct Gap {
  double low = 1e9, high = -1e9;
};

// Returns the gap between a plane and the vertices of a face.
Gap gap_between(const Plane& plane, const RoofSolid& solid, const RoofFace& face) {
  Gap gap;
  for (std::uint32_t v : face.rings[0]) {
    const double distance = signed_distance(plane, solid.vertices[v]);
    gap.low = std::min(gap.low, distance);
    gap.high = std::max(gap.high, distance);
  }
  return gap;
}

bool coplanar(const RoofFace& a, const RoofSolid& solid_b, const RoofFace& b) {
  if (a.part != b.part || dot(a.plane.n, b.plane.n) < 1 - 1e-9) return false;
  const Gap gap = gap_between(a.plane, solid_b, b);
  return std::max(std::abs(gap.low), std::abs(gap.high)) < kSamePlace;
}

bool doubtful_faces(const RoofSolid& solid_a, const RoofFace& a, const RoofSolid& solid_b, const RoofFace& b) {
  if (a.part != b.part || a.part == RoofPart::floor || dot(a.plane.n, b.plane.n) < kSameNormal) return false;
  if (!near_each_other(box_of(solid_a, a), box_of(solid_b, b), kNear) || coplanar(a, solid_b, b)) return false;
  const Gap gap = gap_between(a.plane, solid_b, b);
  return gap.low <= kClearStep && gap.high >= -kClearStep;
}

// Returns whether a side of one face and a side of the other have more than a point in common.
bool share_an_edge(const RoofSolid& solid_a, const RoofFace& a, const RoofSolid& solid_b, const RoofFace& b) {
  const auto for_each_side = [](const RoofSolid& solid, const RoofFace& face, const auto& visit) {
    const auto& ring = face.rings[0];
    for (std::size_t i = 0; i < ring.size(); ++i)
      visit(solid.vertices[ring[i]], solid.vertices[ring[(i + 1) % ring.size()]]);
  };
  bool shared = false;
  for_each_side(solid_a, a, [&](Vec3 from, Vec3 to) {
    const double length = norm(to - from);
    const Vec3 way = (1 / length) * (to - from);
    for_each_side(solid_b, b, [&](Vec3 p, Vec3 q) {
      const double t0 = dot(p - from, way), t1 = dot(q - from, way);
      const bool in_line = norm(p - from - t0 * way) < kSamePlace && norm(q - from - t1 * way) < kSamePlace;
      if (in_line && std::min(std::max(t0, t1), length) - std::max(std::min(t0, t1), 0.0) > 0.1) shared = true;
    });
  });
  return shared;
}

bool same_frame(const RoofFrame& a, const RoofFrame& b) {
  return a.x == b.x && a.y == b.y && a.heading.cos == b.heading.cos;
}

}  // namespace

bool doubtful(const RoofBuilding& a, const RoofBuilding& b) {
  for (const RoofFace& fa : a.solid.faces)
    for (const RoofFace& fb : b.solid.faces)
      if (&fa != &fb && (doubtful_faces(a.solid, fa, b.solid, fb) || doubtful_faces(b.solid, fb, a.solid, fa)))
        return true;
  return false;
}

void number_planes(RoofTown& town) {
  std::vector<std::uint32_t> first;
  std::uint32_t faces = 0;
  for (const RoofBuilding& building : town.buildings) {
    first.push_back(faces);
    faces += static_cast<std::uint32_t>(building.solid.faces.size());
  }
  std::vector<std::uint32_t> parents(faces);
  UnionFind sets(parents);
  for (std::size_t i = 1; i < town.buildings.size(); ++i) {
    const RoofBuilding &a = town.buildings[i - 1], &b = town.buildings[i];
    if (!same_frame(a.frame, b.frame)) continue;
    for (std::uint32_t fa = 0; fa < a.solid.faces.size(); ++fa)
      for (std::uint32_t fb = 0; fb < b.solid.faces.size(); ++fb) {
        const RoofFace &face_a = a.solid.faces[fa], &face_b = b.solid.faces[fb];
        if (face_a.part != RoofPart::floor && coplanar(face_a, b.solid, face_b) &&
            share_an_edge(a.solid, face_a, b.solid, face_b))
          sets.unite(first[i - 1] + fa, first[i] + fb);
      }
  }
  std::vector<std::uint32_t> number(faces, kNoPlane);
  for (std::size_t i = 0; i < town.buildings.size(); ++i) {
    RoofBuilding& building = town.buildings[i];
    for (std::uint32_t f = 0; f < building.solid.faces.size(); ++f) {
      if (building.solid.faces[f].part == RoofPart::floor) {
        building.face_plane.push_back(kNoPlane);
        continue;
      }
      std::uint32_t& id = number[sets.find(first[i] + f)];
      if (id == kNoPlane) id = town.plane_count++;
      building.face_plane.push_back(id);
    }
  }
}

}  // namespace ilot::scan
