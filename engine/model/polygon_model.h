// SPDX-License-Identifier: Apache-2.0
// A building's model as it is in files of any origin: polygons with shared vertices.
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
  std::uint32_t shell = 0;    // number of the shell within the model; surfaces without a solid are one shell
  std::int32_t surface = -1;  // index of the surface to which the face belongs; -1 = none
};

// What a file says of the faces that belong together: a semantic surface of CityJSON or a material of OBJ.
struct ModelSurface {
  std::string type;          // of CityJSON: WallSurface, Window ...; empty = not given
  std::string id;            // of CityJSON; of OBJ the name of the group; may be empty
  std::int32_t parent = -1;  // index of the surface that contains this one, as a wall contains a window; -1 = none
  std::string object_type;   // of CityJSON: Building, Road ...
  std::string material;      // of OBJ: as usemtl names it
};

struct PolygonModel {
  std::string name;
  std::vector<Vec3> vertices;  // CRS coordinates and units, finite
  std::vector<PolygonFace> faces;
  std::vector<ModelSurface> surfaces = {};
};

// Returns Newell's normal of the outer ring. Its length is twice the area; it is zero for degenerate rings.
Vec3 face_normal(const PolygonModel& model, const PolygonFace& face);

// Returns one flag for each face: true for roofs. The kind of a face decides. If no face has a kind, roofs are the
// faces that lean at least 6 degrees from the vertical and rise more than 10 cm above the lowest vertex of the model
// (published models orient their faces in both ways). A model that is nowhere higher than that is completely roof.
std::vector<bool> roof_faces(const PolygonModel& model, double metres_per_unit = 1);

// Divides the face into triangles in the coordinate plane from which it leans least. A face without area gives
// triangles without area. Appends them to `out`.
void append_triangles(const PolygonModel& model, const PolygonFace& face, std::vector<Triangle3>& out);

// True when there are faces and every shell is closed: each edge is used as often in one direction as in the other.
// Vertices at the same place are treated as one.
bool is_closed(const PolygonModel& model);

}  // namespace ilot
