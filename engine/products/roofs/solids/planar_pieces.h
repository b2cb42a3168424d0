// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/model/face_triangles.h"

namespace ilot {

// Divides a face into pieces of which no corner is farther than `most_bent` (metres) from the least squares plane of
// the corners of its piece. Each piece is one ring that passes no vertex twice, oriented as the outer ring of the face.
// They are grown from triangles of the face, the largest piece first, by the triangle whose corner is nearest to the
// plane of the piece; so one corner that is off costs a few triangles and not the whole face. A hole is always between
// two pieces. O(n^2) in corners for each piece.
std::vector<std::vector<std::uint32_t>> planar_pieces(const LatticeVertices& vertices, const FaceRings& rings,
                                                      double most_bent);

}  // namespace ilot
