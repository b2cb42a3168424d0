// SPDX-License-Identifier: Apache-2.0
// Small solids with and without faults.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/solid_model.h"
#include "engine/validity/validity.h"

namespace ilot {

struct Shape {
  std::vector<Vec3> vertices;
  std::vector<FaceRings> faces;
};

// Faces are counter-clockwise seen from outside.
inline Shape box(Vec3 low, Vec3 high) {
  Shape s;
  for (const double z : {low.z, high.z})
    for (const auto& [x, y] : {std::pair(low.x, low.y), {high.x, low.y}, {high.x, high.y}, {low.x, high.y}})
      s.vertices.push_back({x, y, z});
  s.faces = {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}};
  return s;
}

inline Shape turned(Shape s) {
  for (FaceRings& face : s.faces)
    for (auto& ring : face) std::reverse(ring.begin(), ring.end());
  return s;
}

// Returns both shapes in one, each with its own vertices.
inline Shape joined(Shape a, const Shape& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (FaceRings face : b.faces) {
    for (auto& ring : face)
      for (std::uint32_t& i : ring) i += first;
    a.faces.push_back(std::move(face));
  }
  return a;
}

inline SolidShell shell_of(const Shape& s, std::uint32_t first = 0) {
  SolidShell shell;
  for (FaceRings rings : s.faces) {
    for (auto& ring : rings)
      for (std::uint32_t& i : ring) i += first;
    shell.push_back({std::move(rings), ""});
  }
  return shell;
}

inline CityObject object_of(const Shape& s, PrimitiveKind kind = PrimitiveKind::solid) {
  return {"a", "Building", s.vertices, {{kind, "2.2", "a", {{shell_of(s)}}}}};
}

// Returns one solid with several shells.
inline CityObject with_shells(const std::vector<Shape>& shells) {
  CityObject object{"a", "Building", {}, {{PrimitiveKind::solid, "2.2", "a", {{}}}}};
  for (const Shape& s : shells) {
    object.primitives[0].solids[0].push_back(shell_of(s, static_cast<std::uint32_t>(object.vertices.size())));
    object.vertices.insert(object.vertices.end(), s.vertices.begin(), s.vertices.end());
  }
  return object;
}

// Returns one composite of several solids.
inline CityObject with_solids(const std::vector<Shape>& solids, PrimitiveKind kind = PrimitiveKind::composite_solid) {
  CityObject object{"a", "Building", {}, {{kind, "2.2", "a", {}}}};
  for (const Shape& s : solids) {
    object.primitives[0].solids.push_back({shell_of(s, static_cast<std::uint32_t>(object.vertices.size()))});
    object.vertices.insert(object.vertices.end(), s.vertices.begin(), s.vertices.end());
  }
  return object;
}

using Codes = std::vector<int>;

inline Codes codes(const CityObject& object) {
  return codes_of(validate_object(object));
}

inline Codes codes(const Shape& s, PrimitiveKind kind = PrimitiveKind::solid) {
  return codes(object_of(s, kind));
}

}  // namespace ilot
