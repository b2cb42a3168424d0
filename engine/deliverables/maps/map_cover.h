// SPDX-License-Identifier: Apache-2.0
// What the ground is covered with, as an image under the map.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernels/geometry/flat_box.h"

namespace ilot {

// The later ones hide the earlier ones where a pixel has several.
enum class GroundCover : std::uint8_t { unseen, ground, crown, building };
constexpr std::size_t kCovers = 4;

// Rows from the north.
struct CoverImage {
  FlatBox box;  // CRS
  std::uint32_t width = 0, height = 0;
  std::vector<GroundCover> pixels;
};

// Where a map gets its cover from. No pixel of an image may be smaller than one of the source.
struct CoverSource {
  double pixel_m = 0;                                       // metres
  std::function<void(std::span<CoverImage> images)> paint;  // sets the pixels that are not `unseen`; empty: no cover
};

}  // namespace ilot
