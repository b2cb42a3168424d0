// SPDX-License-Identifier: Apache-2.0
// Shells: codes 101 to 307.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/validity/validate_face.h"

namespace ilot {

// The origin and the step of an object's integer coordinates.
struct ValidityLattice {
  Vec3 origin;
  double step = 1e-6;
};

// The lattice has its origin at the lowest corner. Its step is a micrometre, or the least power of ten times a
// micrometre at which the object fits into 2^36 steps.
ValidityLattice lattice_of(std::span<const Vec3> vertices);

enum class ShellRule : std::uint8_t {
  faces,    // a MultiSurface: each face by itself
  surface,  // a CompositeSurface: a manifold
  closed,   // a solid's boundary
};

struct CheckedShell {
  LatticeVertices vertices;
  std::vector<TriangleCorners> triangles;  // empty after a fault of a face
  Faults faults;
};

// Checks a shell. Vertices at most params.snap apart become one, the first in order of use. Then come these checks,
// each only when all before are passed: the faces (101 to 208), their bends (204), their number (301), how triangles
// fit together (303, 307), pieces (305), holes (302), and triangles that meet (306). `name` goes into `where`.
CheckedShell check_shell(std::span<const Vec3> vertices, const SolidShell& shell, ShellRule rule,
                         const ValidityLattice& lattice, const ValidityParams& params, const std::string& name);

}  // namespace ilot
