// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// The boundary of a segment on its plane. Coordinates in the CRS of the inputs.
struct Outline {
  using Ring = std::vector<Vec3>;  // from the last vertex an edge leads to the first
  using Part = std::vector<Ring>;  // the outer ring, then its holes
  std::uint32_t plane_id = 0;
  std::vector<Part> parts;  // none when the segment's points are too far apart
};

}  // namespace ilot
