// SPDX-License-Identifier: Apache-2.0
// The ground under a cloud that nobody has classified.
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

struct GroundSurfaceParams {
  double pixel_mm = 1000;     // side of a pixel
  double steepest = 0.3;      // rise over run of ground
  double roughness_mm = 300;  // that ground rises from pixel to pixel beside its slope
};

// Widest half windows that the surface is opened with, in pixels; buildings up to 49 pixels across disappear.
constexpr std::uint32_t kGroundReaches[] = {1, 2, 4, 8, 16, 24};

// How far a pixel's answer looks: pixels farther away cannot change it.
constexpr std::uint32_t kGroundHalo = 2 * (1 + 2 + 4 + 8 + 16 + 24);

// Height of the ground per pixel from the lowest heights (millimetres; kNoHeight = no point): openings with growing
// windows; what stands out of one by more than the slope allows over the window's growth is taken down to it (Zhang et
// al. 2003, "A progressive morphological filter for removing nonground measurements from airborne LIDAR data").
// kNoHeight far from all points. Exact and local: parts with a halo of kGroundHalo give the whole. O(pixels).
Image ground_surface(const Image& lowest, const GroundSurfaceParams& params = {});

}  // namespace ilot
