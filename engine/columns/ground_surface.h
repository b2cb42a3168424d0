// SPDX-License-Identifier: Apache-2.0
// Finds the ground under an unclassified cloud.
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

struct GroundSurfaceParams {
  double pixel_mm = 1000;     // side of a pixel
  double steepest = 0.3;      // greatest slope of the ground, rise over run
  double roughness_mm = 300;  // greatest rise of the ground from pixel to pixel in addition to its slope
};

// Half widths in pixels of the windows with which the surface is opened; buildings of up to 49 pixels disappear.
constexpr std::uint32_t kGroundReaches[] = {1, 2, 4, 8, 16, 24};

// The halo of a pixel: pixels farther away do not change its result.
constexpr std::uint32_t kGroundHalo = 2 * (1 + 2 + 4 + 8 + 16 + 24);

// Gives the height of the ground per pixel from the lowest heights (millimetres; kNoHeight = no point). The image is
// opened with growing windows. A pixel that is above an opening by more than the slope allows for the growth of the
// window is lowered to the opening (Zhang et al. 2003, "A progressive morphological filter for removing nonground
// measurements from airborne LIDAR data"). The result is kNoHeight far from all points. The filter is exact and local:
// parts with a halo of kGroundHalo give the same result as the whole image. O(pixels).
Image ground_surface(const Image& lowest, const GroundSurfaceParams& params = {});

}  // namespace ilot
