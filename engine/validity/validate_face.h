// SPDX-License-Identifier: Apache-2.0
// Rings and polygons: codes 101 to 208.
#pragma once
#include <span>
#include <vector>

#include "engine/model/face_triangles.h"
#include "engine/validity/validity.h"
#include "kernels/meshes/manifold.h"

namespace ilot {

// Faults of one face but 204, which needs all faces of a shell to be right: `where` is the size of the fault, or empty.
// Rings that are too short (101) or have equal corners in a row (102) end it, then a plane (least squares) too far away
// (203), then an outer ring that crosses itself or has no area on that plane (104), then rings of one orientation
// (208), then how rings lie to each other (201, 202, 205, 206, 207: GEOS).
Faults validate_face(const LatticeVertices& vertices, const FaceRings& rings, const ValidityParams& params);

// Cosine of the largest angle between the first triangle's normal and another's; 1 for fewer than two with areas.
double least_normals_cosine(const LatticeVertices& vertices, std::span<const TriangleCorners> triangles);

}  // namespace ilot
