// SPDX-License-Identifier: Apache-2.0
// Inside of the raster kernels and of streets: the shortest links between regions, as seen through a window on an
// image.
#pragma once
#include <cstdint>
#include <tuple>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

struct LinkRegionsParams {
  Height step = 1000;              // units; regions are flat zones within it, and links climb no more
  std::uint32_t max_length = 100;  // pixels without a height that a link may cross
};

// A part of an image with so many pixels around it; numbers of pixels are those of the whole, row by row.
struct LinkWindow {
  Image heights;                     // with the halo
  std::vector<std::uint32_t> zones;  // of the same pixels; 0 = none
  std::vector<std::uint8_t> inside;  // 1: belongs to the image
  bool straight = true;  // a shortest way in the window between pixels of the image, as far as links go, stays in it
  std::uint32_t halo = 0;
  std::int64_t x = 0, y = 0;  // of the window's first pixel in the whole
  std::int64_t whole_width = 0;
};

struct LinkPixel {
  std::uint64_t pixel;  // in the whole
  Height height;
};

struct RegionLink {
  std::uint32_t length = 0;
  std::uint64_t end_a = 0, end_b = 0, p = 0, q = 0;  // end_a < end_b; p and q are where the two ways meet
  std::uint32_t zone_a = 0, zone_b = 0;
  std::vector<LinkPixel> way = {};  // from a to b, the ends left out
  auto order() const { return std::tie(length, end_a, end_b, p, q); }
};

// How far a window has to see beyond the pixels that it owns.
inline std::uint32_t link_halo(const LinkRegionsParams& params) {
  return (params.max_length + 1) / 2 + 1;
}

// The links that the pixels inside of the halo own and that a least spanning tree of the whole may need (no others of
// this window close the same gap by shorter ones), the shortest first.
std::vector<RegionLink> links_in(const LinkWindow& window, const LinkRegionsParams& params);

}  // namespace ilot
