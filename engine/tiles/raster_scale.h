// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstdint>

#include "kernels/rasters/image.h"

namespace ilot {

// The units of the images of a street.
struct RasterScale {
  double unit = 0.001;  // metres of one unit of height
  double pixel = 0.05;  // metres, side of a pixel

  // The height of a bin of an occupancy image in metres. It is two pixels, which is the sampling step from the street
  // (a pixel is half of it), so that each bin of an upright surface contains a point.
  double bin() const { return 2 * pixel; }
  Height units(double metres) const { return static_cast<Height>(std::floor(metres / unit + 0.5)); }
  std::uint32_t pixels(double metres) const { return static_cast<std::uint32_t>(std::floor(metres / pixel + 0.5)); }
  std::uint32_t area(double square_metres) const {
    return static_cast<std::uint32_t>(std::floor(square_metres / (pixel * pixel) + 0.5));
  }
};

}  // namespace ilot
