// SPDX-License-Identifier: Apache-2.0
// The form of what stands in a cell, from its points.
#pragma once
#include <array>
#include <cstdint>

#include "kernels/rasters/image.h"

namespace ilot {

// Derived: points at random in a cell have a standard deviation of side / sqrt(12) along each axis; half of it is thin.
constexpr double kThin = 0.5;
// Choice: walls that lean by 17 degrees; steeper mansards are walls, and no harm is done.
constexpr double kMostUprightNormal = 0.3;  // |z| of the normal of a wall
// The form of the points of a cell that are high above the terrain.
enum class StandingForm : std::uint8_t {
  none = 0,      // too few points
  upright = 1,   // a wall: points near an upright plane, spread over the cell
  inclined = 2,  // a roof: points near a plane that is not upright
  pole = 3,      // points near an upright line
  volume = 4,    // a crown: points on no plane
};

// What stands in a cell that has a wall or a roof, or a crown or a part of a building above.
// `eaves` are an overhang of a roof.
enum class Structure : std::uint8_t { none = 0, wall = 1, roof = 2, crown = 3, overhang = 4, eaves = 5 };

// Whether a part of a building is above, and what is below it is free.
constexpr bool is_overhang(Structure s) {
  return s == Structure::overhang || s == Structure::eaves;
}

// Whether only what is high above the ground belongs to the structure: below it is free, and objects stand there.
constexpr bool is_overhead(Structure s) {
  return s == Structure::crown || is_overhang(s);
}

// Sums over the points of a cell, in whole units from the cell's corner and the terrain, so that order does not matter.
class StandingPoints {
 public:
  // `x`, `y`: units from the corner of the cell; `height`: above the terrain. Points lower than `least` count for the
  // top alone.
  void add(std::int64_t x, std::int64_t y, Height height, Height least) {
    top_ = top_ > height ? top_ : height;
    if (height < least) return;
    ++n_;
    const std::array<std::int64_t, 3> p{x, y, height < kMost ? height : kMost};
    for (std::size_t a = 0, k = 0; a < 3; ++a) {
      sum_[a] += p[a];
      for (std::size_t b = a; b < 3; ++b) squares_[k++] += p[a] * p[b];
    }
  }

  // The highest point above the terrain; kNoHeight where none is above it.
  Height top() const { return top_; }
  // The standard deviations of the points along their principal axes, smallest first, in units, and |z| of the
  // direction of the smallest; all 0 where there are too few points.
  struct Spread {
    std::array<double, 3> deviations{};
    double normal_z = 0;
  };
  Spread spread() const;
  // Whether the points lie near a plane, and which, for cells with a side of `side` units.
  StandingForm shape(double side) const { return shape(spread(), side); }
  StandingForm shape(const Spread& spread, double side) const;

 private:
  static constexpr Height kMost = 1 << 20;  // units; squares and their sums stay below 2^63
  Height top_ = kNoHeight;
  std::int64_t n_ = 0;
  std::array<std::int64_t, 3> sum_{};
  std::array<std::int64_t, 6> squares_{};
};

// The bins of height above the terrain in which a pixel has points, the last one for all that is higher.
using HeightBins = std::uint32_t;
constexpr std::uint32_t kHeightBins = 32;

struct BinRange {
  std::uint32_t first = 0, last = 0;
};

// Whether a pixel shows something upright: two thirds of the bins of a range contain a point. The range begins above
// what lies on the ground and ends at the highest point of the cell, or of the pixel where it is tall: a wall may end
// below a crown. What is behind the windows of a wall is not upright, and most of a crown is not.
bool is_upright(HeightBins bins, BinRange range);

}  // namespace ilot
