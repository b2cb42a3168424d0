// SPDX-License-Identifier: Apache-2.0
// Checks primitives: shells within a solid (401 to 405), solids within a composite (501 to 503), empty primitives (902)
// and solids of one building (601).
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/validity/solid_relation.h"
#include "engine/validity/validate_shell.h"

namespace ilot {

struct CheckedPrimitive {
  Faults faults;
  std::vector<SolidBoundary> solids;  // solids of the primitive, when there is no fault
};

CheckedPrimitive check_primitive(std::span<const Vec3> vertices, const Primitive& primitive,
                                 const ValidityLattice& lattice, const ValidityParams& params, const std::string& name);

}  // namespace ilot
