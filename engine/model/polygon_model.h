// SPDX-License-Identifier: Apache-2.0
// A building's model as files hold it: polygons over shared vertices, whoever made it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/geometry/closest.h"

namespace ilot {

enum class FaceKind : std::uint8_t { unknown, roof, wall, ground };

struct PolygonFace {
  std::vector<std::vector<std::uint32_t>> rings;  // indices of vertices, outer ring first, at least 3 corners each
  FaceKind kind = FaceKind::unknown;
  std::uint32_t shell = 0;  // number of the shell within the model; surfaces without a solid count as one
};

struct PolygonModel {
  std::string name;
  std::vector<Vec3> vertices;  // CRS coordinates and units, finite
  std::vector<PolygonFace> faces;
};

// Newell's normal of the outer ring, its length twice the area; zero for degenerate rings.
Vec3 face_normal(const PolygonModel& model, const PolygonFace& face);

// The faces that are roofs: by their kind, or, where nothing says so, those that lean at least 6 degrees from the
// vertical and rise more than 10 cm above the model's lowest vertex (published models orient their faces either way). A
// model that is nowhere higher than that is all roof. Flags, one per face.
std::vector<bool> roof_faces(const PolygonModel& model, double metres_per_unit = 1);

// The face cut into triangles along the coordinate plane that it leans least against; faces without area give some
// without area. Appends to `out`.
void append_triangles(const PolygonModel& model, const PolygonFace& face, std::vector<Triangle3>& out);

// True when there are faces and every shell is closed: each edge is used as often in one direction as in the other.
// Vertices at the same place are one.
bool is_closed(const PolygonModel& model);

}  // namespace ilot
