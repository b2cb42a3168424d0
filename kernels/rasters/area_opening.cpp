// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/area_opening.h"

#include <cassert>

#include "kernels/rasters/padded.h"
#include "kernels/rasters/pixel_order.h"

namespace ilot {
namespace {

constexpr std::uint32_t kUnseen = 0xffffffffu;

// The parts of the image above a height that sinks. A root is the last, so the lowest, pixel of its part.
struct Parts {
  std::vector<std::uint32_t> parent;  // kUnseen until the height has reached the pixel
  std::vector<std::uint32_t> area;    // of roots; `enough` and more are the same

  std::uint32_t root(std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
};

// A part that is big enough keeps its heights: it is cut off there, and what joins it later is big enough too.
void take_in(Parts& parts, const std::vector<Height>& f, std::uint32_t p, std::uint32_t neighbour,
             std::uint32_t enough) {
  const std::uint32_t r = parts.root(neighbour);
  if (r == p) return;
  if (f[r] == f[p] || parts.area[r] < enough) {
    parts.area[p] = std::min(enough, parts.area[p] + parts.area[r]);
    parts.parent[r] = p;
  } else {
    parts.area[p] = enough;
  }
}

}  // namespace

Image area_opening(const Image& image, std::uint32_t area, Adjacency adjacency) {
  assert(area >= 1 && area < (1u << 31));
  const PaddedFrame frame(image.width, image.height);
  std::vector<Height> f = padded(image, kNoHeight);
  const std::vector<std::uint32_t> order = pixels_from_the_top({frame.stride, image.height + 2, f});
  Parts parts{std::vector<std::uint32_t>(f.size(), kUnseen), std::vector<std::uint32_t>(f.size(), 1)};
  const auto steps = frame.steps();
  for (const std::uint32_t p : order) {
    parts.parent[p] = p;
    for (std::size_t s = 0; s < step_count(adjacency); ++s)
      if (const std::uint32_t q = p + steps[s]; parts.parent[q] != kUnseen) take_in(parts, f, p, q, area);
  }
  for (std::size_t i = order.size(); i-- > 0;) {
    const std::uint32_t p = order[i], parent = parts.parent[p];
    f[p] = parent != p ? f[parent] : parts.area[p] >= area ? f[p] : kNoHeight;
  }
  return {image.width, image.height, unpadded<Height>(frame, f)};
}

}  // namespace ilot
