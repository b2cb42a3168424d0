// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/area_opening.h"

#include <cassert>

#include "kernels/rasters/padded.h"
#include "kernels/rasters/pixel_order.h"

namespace ilot {
namespace {

constexpr std::int32_t kUnseen = 0;

// The connected components of the image above a height that sinks. The root of a component is its last, and so its
// lowest, pixel.
// The link of a pixel is kUnseen until the height has reached it. Then it is the index of its parent (no pixel has the
// index 0, which is border), or, for a root, minus its area.
class Parts {
 public:
  Parts(std::span<const Height> f, std::int32_t enough) : f_(f), enough_(enough), link_(f.size(), kUnseen) {}

  void start(std::uint32_t p) { link_[p] = -1; }
  bool seen(std::uint32_t p) const { return link_[p] != kUnseen; }

  // A component that is large enough keeps its heights: it is cut off there. A component that joins it is large enough
  // too.
  void join(std::uint32_t p, std::uint32_t neighbour) {
    const std::uint32_t r = root(neighbour);
    if (r == p) return;
    if (-link_[r] < enough_ || f_[r] == f_[p]) {
      link_[p] = std::max(link_[p] + link_[r], -enough_);
      link_[r] = static_cast<std::int32_t>(p);
    } else {
      link_[p] = -enough_;
    }
  }

  // Returns the final height of a pixel whose parent is already final.
  Height final_height(std::uint32_t p) const {
    if (link_[p] > 0) return f_[static_cast<std::size_t>(link_[p])];
    return -link_[p] >= enough_ ? f_[p] : kNoHeight;
  }

 private:
  std::uint32_t root(std::uint32_t i) {
    while (link_[i] > 0) {
      const auto up = static_cast<std::uint32_t>(link_[i]);
      if (link_[up] <= 0) return up;
      link_[i] = link_[up];
      i = static_cast<std::uint32_t>(link_[i]);
    }
    return i;
  }

  std::span<const Height> f_;
  std::int32_t enough_;
  std::vector<std::int32_t> link_;
};

}  // namespace

Image area_opening(const Image& image, std::uint32_t area, Adjacency adjacency) {
  assert(area >= 1 && area < (1u << 30));
  const PaddedFrame frame(image.width, image.height);
  std::vector<Height> f = padded(image, kNoHeight);
  const std::vector<std::uint32_t> order = pixels_from_the_top({frame.stride, image.height + 2, f});
  Parts parts(f, static_cast<std::int32_t>(area));
  const auto steps = frame.steps();
  for (const std::uint32_t p : order) {
    parts.start(p);
    for (std::size_t s = 0; s < step_count(adjacency); ++s)
      if (parts.seen(p + steps[s])) parts.join(p, p + steps[s]);
  }
  for (std::size_t i = order.size(); i-- > 0;) f[order[i]] = parts.final_height(order[i]);
  return {image.width, image.height, unpadded<Height>(frame, f)};
}

}  // namespace ilot
