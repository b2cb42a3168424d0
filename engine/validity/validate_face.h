// SPDX-License-Identifier: Apache-2.0
// Rings and polygons: codes 101 to 208.
#pragma once
#include <span>
#include <vector>

#include "engine/model/face_triangles.h"
#include "engine/validity/validity.h"
#include "kernels/meshes/manifold.h"

namespace ilot {

// Returns the faults of one face except 204, which is checked when all faces of a shell are valid. `where` is the size
// of the fault, or empty. The checks run in this order, and a fault stops the later ones: rings that are too short
// (101) or have equal consecutive corners (102); distance from the least-squares plane (203); an outer ring that
// crosses itself or has no area on that plane (104); rings of the same orientation (208); the relation of the rings
// (201, 202, 205, 206, 207: GEOS).
Faults validate_face(const LatticeVertices& vertices, const FaceRings& rings, const ValidityParams& params);

// The cosine of the largest angle between the first triangle's normal and that of another one; 1 for fewer than two
// triangles with areas.
double least_normals_cosine(const LatticeVertices& vertices, std::span<const TriangleCorners> triangles);

}  // namespace ilot
