// SPDX-License-Identifier: Apache-2.0
// City objects with all their geometries, nested as in ISO 19107 and CityJSON. Validity is tested on them.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

using FaceRings = std::vector<std::vector<std::uint32_t>>;  // indices of vertices, outer ring first, not closed

// The id is the name of the face in the file, or empty.
struct SolidFace {
  FaceRings rings;
  std::string id;
};

using SolidShell = std::vector<SolidFace>;
using SolidShells = std::vector<SolidShell>;  // of one solid: the outer shell, then inner ones

enum class PrimitiveKind : std::uint8_t { multi_surface, composite_surface, solid, multi_solid, composite_solid };

struct Primitive {
  PrimitiveKind kind = PrimitiveKind::solid;
  std::string lod;                  // empty = not given
  std::string owner;                // id of the object or part to which this geometry belongs
  std::vector<SolidShells> solids;  // surfaces without a solid are one solid of one shell
};

// An object and the geometries of its parts. Indices of vertices are in range; coordinates are finite, in metres or CRS
// units.
struct CityObject {
  std::string id, type;
  std::vector<Vec3> vertices;
  std::vector<Primitive> primitives;
  std::vector<std::string> parts = {};  // ids of the objects whose geometries are included
};

}  // namespace ilot
