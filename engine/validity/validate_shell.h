// SPDX-License-Identifier: Apache-2.0
// Shells: codes 101 to 307.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/validity/validate_face.h"

namespace ilot {

// Where an object's coordinates are counted from, and how finely.
struct ValidityLattice {
  Vec3 origin;
  double step = 1e-6;
};

// A micrometre from the lowest corner, or the least power of ten of it at which objects fit 2^36 steps.
ValidityLattice lattice_of(std::span<const Vec3> vertices);

enum class ShellRule : std::uint8_t {
  faces,    // a MultiSurface: each face for itself
  surface,  // a CompositeSurface: a manifold
  closed,   // a solid's boundary
};

struct CheckedShell {
  LatticeVertices vertices;
  std::vector<TriangleCorners> triangles;  // none after a fault of a face
  Faults faults;
};

// Vertices at most params.snap apart become one, the first in order of use. Then, each only when all before are right:
// the faces (101 to 208), their bends (204), their number (301), how triangles fit together (303, 307), pieces (305),
// holes (302), and triangles that meet (306). `name` goes into `where`.
CheckedShell check_shell(std::span<const Vec3> vertices, const SolidShell& shell, ShellRule rule,
                         const ValidityLattice& lattice, const ValidityParams& params, const std::string& name);

}  // namespace ilot
