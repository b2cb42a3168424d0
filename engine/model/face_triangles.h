// SPDX-License-Identifier: Apache-2.0
// Faces with holes as triangles: one way for files that have no holes and for the validity of solids.
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

// A face's least squares plane, and where its corners lie on it.
struct FacePlane {
  Index3 anchor;  // of the offsets
  Vec3 centre, u, v, n;
};

// From a place of the lattice to a vertex.
Vec3 offset(const LatticeVertices& vertices, std::uint32_t vertex, Index3 from);

FacePlane plane_of(const LatticeVertices& vertices, const FaceRings& rings);

// Corners on the plane, in steps of the vertices' lattice, coarser only where a face is wider than it allows.
std::vector<std::vector<Point2>> flattened(const FacePlane& plane, const LatticeVertices& vertices,
                                           const FaceRings& rings);

bool is_one_triangle(const FaceRings& rings);

// The face cut into triangles, constrained Delaunay on its plane, which turn as its outer ring does. Rings are simple
// and do not cross each other.
std::vector<TriangleCorners> triangulate_face(const LatticeVertices& vertices, const FaceRings& rings);

}  // namespace ilot
