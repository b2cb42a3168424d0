// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels and to streets: the shortest links between regions, as seen through a window on an
// image.
#pragma once
#include <cstdint>
#include <tuple>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

struct LinkRegionsParams {
  Height step = 1000;              // units; regions are flat zones within it, and links do not climb more
  std::uint32_t max_length = 100;  // pixels without a height that a link may cross
};

// A part of an image with `halo` pixels around it. Pixel numbers are those of the whole image, row by row.
struct LinkWindow {
  Image heights;                     // with the halo
  std::vector<std::uint32_t> zones;  // of the same pixels; 0 = none
  std::vector<std::uint8_t> inside;  // 1: the pixel belongs to the image
  bool straight = true;  // a shortest path between pixels of the image, as long as a link may be, stays in the window
  std::uint32_t halo = 0;
  std::int64_t x = 0, y = 0;  // of the window's first pixel in the whole image
  std::int64_t whole_width = 0;
};

struct LinkPixel {
  std::uint64_t pixel;  // number in the whole image
  Height height;
};

struct RegionLink {
  std::uint32_t length = 0;
  std::uint64_t end_a = 0, end_b = 0, p = 0, q = 0;  // end_a < end_b; the two half paths meet at p and q
  std::uint32_t zone_a = 0, zone_b = 0;
  std::vector<LinkPixel> way = {};  // from a to b, without the ends
  auto order() const { return std::tie(length, end_a, end_b, p, q); }
};

// Returns how far a window has to extend beyond the pixels that it owns.
inline std::uint32_t link_halo(const LinkRegionsParams& params) {
  return (params.max_length + 1) / 2 + 1;
}

// Returns the links that the pixels inside of the halo own and that a minimum spanning tree of the whole image may
// need, the shortest first. It leaves out a link when shorter links of this window already join its two regions.
std::vector<RegionLink> links_in(const LinkWindow& window, const LinkRegionsParams& params);

}  // namespace ilot
