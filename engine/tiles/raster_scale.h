// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernels/rasters/image.h"

namespace ilot {

// Choice: the lower half of a car has two bins, and so have its windows; 31 bins reach to nine metres.
constexpr double kHighestBin = 0.3;  // metres

// The units of the images of a street.
struct RasterScale {
  double unit = 0.001;  // metres of one unit of height
  double pixel = 0.05;  // metres, side of a pixel

  // The height of a bin of an occupancy image in metres. It is two pixels, which is the sampling step from the street
  // (a pixel is half of it), so that each bin of an upright surface contains a point, but not so high that cars and
  // bushes fill the same few bins.
  double bin() const { return std::min(2 * pixel, kHighestBin); }
  Height units(double metres) const { return static_cast<Height>(std::floor(metres / unit + 0.5)); }
  std::uint32_t pixels(double metres) const { return static_cast<std::uint32_t>(std::floor(metres / pixel + 0.5)); }
  std::uint32_t area(double square_metres) const {
    return static_cast<std::uint32_t>(std::floor(square_metres / (pixel * pixel) + 0.5));
  }
};

}  // namespace ilot
