// SPDX-License-Identifier: Apache-2.0
// City objects with all their geometries, nested as ISO 19107 and CityJSON nest them: what validity is judged on.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

using FaceRings = std::vector<std::vector<std::uint32_t>>;  // numbers of vertices, outer ring first, not closed

// The id is what files call the face, or empty.
struct SolidFace {
  FaceRings rings;
  std::string id;
};

using SolidShell = std::vector<SolidFace>;
using SolidShells = std::vector<SolidShell>;  // of one solid: the outer shell, then inner ones

enum class PrimitiveKind : std::uint8_t { multi_surface, composite_surface, solid, multi_solid, composite_solid };

struct Primitive {
  PrimitiveKind kind = PrimitiveKind::solid;
  std::string lod;                  // empty = not said
  std::string owner;                // id of the object or part whose geometry this is
  std::vector<SolidShells> solids;  // surfaces: one solid of one shell
};

// An object and the geometries of its parts. Numbers of vertices in range, coordinates finite, in metres or CRS units.
struct CityObject {
  std::string id, type;
  std::vector<Vec3> vertices;
  std::vector<Primitive> primitives;
  std::vector<std::string> parts = {};  // ids of the objects whose geometries are here too
};

}  // namespace ilot
