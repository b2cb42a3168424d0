// SPDX-License-Identifier: Apache-2.0
// A cloud in the caller's memory as an input of a run (run.h): nothing is copied, and no file is needed.
//
//   ilot::RunOptions options;
//   options.arrays.push_back({.name = "town", .x = x, .y = y, .z = z, .crs = "EPSG:2154"});
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace ilot {

// Arrays of one length, not owned, finite and unchanged until the run has ended. A coordinate is taken as the nearest
// whole multiple of `scale` from an offset, the whole number below the first place, as CloudWriter writes it: the run
// gives the same planes, roofs ... as one of the file that CloudWriter makes of the arrays.
//
// The labels of its points are written to points/NAME.npy, one record a point in the order of the arrays, with the
// fields that a labelled cloud has (docs/outputs.md): NumPy maps it into memory.
struct ArrayCloud {
  std::string name = "points";                        // of the file with its labels, and in messages: no path
  std::span<const double> x, y, z;                    // CRS units
  std::span<const std::uint16_t> intensity = {};      // empty = zeros, so are those below
  std::span<const std::uint8_t> classification = {};  // ASPRS codes: 2 ground, 6 building
  std::span<const std::uint16_t> red = {}, green = {}, blue = {};  // 0 to 65535
  std::string crs = {};                                            // "EPSG:2154", or empty: not said
  double scale = 0.001;                                            // CRS units
};

}  // namespace ilot
