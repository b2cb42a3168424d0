// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/whole_street.h"

#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/reconstruct.h"
#include "kernels/rasters/box_minimum.h"
#include "tests/oracles/whole_fill.h"
namespace ilot::test {
namespace {

Image masked(const Ground& ground) {
  Image out = ground.filled;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (ground.mask[i] == 0) out.values[i] = kNoHeight;
  return out;
}

// Returns 1 for the pixels outside the mask that touch it across a side or a corner.
std::vector<std::uint8_t> ring_around(const Image& inside) {
  const auto w = std::int64_t{inside.width}, h = std::int64_t{inside.height};
  std::vector<std::uint8_t> ring(inside.size(), 0);
  for (std::int64_t y = 0; y < h; ++y)
    for (std::int64_t x = 0; x < w; ++x) {
      if (inside.values[static_cast<std::size_t>(y * w + x)] == kNoHeight) continue;
      for (std::int64_t v = std::max<std::int64_t>(y - 1, 0); v <= std::min(y + 1, h - 1); ++v)
        for (std::int64_t u = std::max<std::int64_t>(x - 1, 0); u <= std::min(x + 1, w - 1); ++u)
          if (const auto q = static_cast<std::size_t>(v * w + u); inside.values[q] == kNoHeight) ring[q] = 1;
    }
  return ring;
}

// Returns the image upside down, with the ring. Outside the ring it is kNoHeight, the lowest value.
Image turned_over_with_ring(const Image& inside, std::uint32_t reach) {
  const auto ring = ring_around(inside);
  const Image around = box_minimum(inside, reach);
  Image out = inside;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (inside.values[i] != kNoHeight) {
      out.values[i] = -inside.values[i];
    } else if (ring[i] != 0) {
      out.values[i] = -around.values[i];
    }
  }
  return out;
}

// Returns how much the filling raises each pixel inside, and kNoHeight outside.
Image raised_by(const Image& filled, const Image& over, const Image& inside) {
  Image out = inside;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (inside.values[i] != kNoHeight) out.values[i] = filled.values[i] - over.values[i];
  return out;
}

Image between(const Image& image, Height least, Height most) {
  Image out = image;
  for (Height& v : out.values) v = v >= least && v <= most ? 0 : kNoHeight;
  return out;
}

// Repeats the filling with an outlet in every pixel of large low plateaus. Returns false when there are no such
// plateaus.
bool drain(const Image& depth, const Image& over, Height least, Height most, std::uint32_t area, Image& filled) {
  const PixelLabels low = flat_zones(between(depth, least, most), 0, Adjacency::four);
  const auto sizes = zone_sizes(low);
  Image marker = filled;
  bool any = false;
  for (std::size_t i = 0; i < marker.size(); ++i) {
    if (low.of[i] == 0 || sizes[low.of[i]] < area) continue;
    marker.values[i] = over.values[i];
    any = true;
  }
  if (any) filled = reconstruct_by_erosion(marker, over, Adjacency::eight);
  return any;
}

}  // namespace

Artefacts find_artefacts(const Ground& ground, const RasterScale& scale, const ArtefactParams& params) {
  const Height least = scale.units(params.least_height);
  const Image inside = masked(ground);
  const Image over = turned_over_with_ring(inside, scale.pixels(params.ring_reach));
  Image filled = fill_holes(over, Adjacency::eight);
  Artefacts found{raised_by(filled, over, inside), ground.mask};
  if (drain(found.height, over, least, scale.units(params.highest_kerb), scale.area(params.least_plateau), filled))
    found.height = raised_by(filled, over, inside);
  for (std::size_t i = 0; i < found.ground.size(); ++i) {
    if (found.height.values[i] >= least) {
      found.ground[i] = 0;
    } else {
      found.height.values[i] = kNoHeight;
    }
  }
  return found;
}

}  // namespace ilot::test
