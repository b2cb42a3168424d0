// SPDX-License-Identifier: Apache-2.0
// Inside of the raster kernels: the pixel of a point.
#pragma once
#include <algorithm>

#include "kernels/rasters/grid.h"

namespace ilot {

class PixelAt {
 public:
  explicit PixelAt(const GridFrame& frame)
      : x_{axis_of(frame.x, frame.pixel, frame.width)}, y_{axis_of(frame.y, frame.pixel, frame.height)} {}

  // kNoPixel outside the frame.
  std::uint32_t operator()(float x, float y) const {
    const std::uint32_t column = x_.cell(x), row = y_.cell(y);
    return column < x_.cells && row < y_.cells ? row * x_.cells + column : kNoPixel;
  }

 private:
  // Half a unit is added so that the true quotient keeps 2^-25 away from any whole number, more than the product can be
  // off: offsets stay below 2^26, so truncation is exact for those that are not negative.
  struct Axis {
    double from, per_unit;
    std::uint32_t cells;

    std::uint32_t cell(float v) const {
      const double steps = (static_cast<double>(v) - from + 0.5) * per_unit;
      return steps > 0 ? static_cast<std::uint32_t>(std::min(steps, 4e9)) : kNoPixel;
    }
  };

  static Axis axis_of(std::int64_t from, std::int64_t pixel, std::uint32_t cells) {
    return {static_cast<double>(from), 1 / static_cast<double>(pixel), cells};
  }

  Axis x_, y_;
};

}  // namespace ilot
