// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// The measured and the expected density of the points of a segment on its plane. Rows begin at the top. Pixel (column,
// row) begins at origin + left + column * pixel along `right` and top - row * pixel along `up`.
struct DensityMap {
  std::uint32_t plane_id = 0;
  Vec3 origin;                          // on the plane, in the CRS of the inputs
  Vec3 right, up;                       // axes of the plane, of unit length: right is horizontal
  double left = 0, top = 0, pixel = 0;  // CRS units
  std::uint32_t width = 0, height = 0;
  std::vector<float> measured;   // points per square metre; NaN where less than half of a pixel is inside
  std::vector<float> predicted;  // the same; also NaN where no station sees the plane
};

}  // namespace ilot
