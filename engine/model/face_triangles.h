// SPDX-License-Identifier: Apache-2.0
// Divides faces with holes into triangles. File formats without holes and the validity of solids use the same method.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/model/solid_model.h"
#include "kernels/core/types.h"
#include "kernels/delaunay/delaunay.h"
#include "kernels/meshes/manifold.h"

namespace ilot {

// Vertices of a shell on a lattice: coordinates are whole steps.
struct LatticeVertices {
  std::vector<Index3> points;
  double step = 1e-6;  // CRS units
};

// The least squares plane of a face, and the places of its corners on it.
struct FacePlane {
  Index3 anchor;  // of the offsets
  Vec3 centre, u, v, n;
};

// Returns the vector from a place of the lattice to a vertex.
Vec3 offset(const LatticeVertices& vertices, std::uint32_t vertex, Index3 from);

FacePlane plane_of(const LatticeVertices& vertices, const FaceRings& rings);

// The largest distance of a corner from the plane.
double farthest_from(const FacePlane& plane, const LatticeVertices& vertices, const FaceRings& rings);

// Returns the corners on the plane, in steps of the vertices' lattice. The steps are coarser only when the face is too
// wide for them.
std::vector<std::vector<Point2>> flattened(const FacePlane& plane, const LatticeVertices& vertices,
                                           const FaceRings& rings);

bool is_one_triangle(const FaceRings& rings);

// Divides the face into triangles by a constrained Delaunay triangulation on its plane. The triangles have the
// orientation of its outer ring. Rings are simple and do not cross each other.
std::vector<TriangleCorners> triangulate_face(const LatticeVertices& vertices, const FaceRings& rings);

}  // namespace ilot
