// SPDX-License-Identifier: Apache-2.0
// Internal to find_object_candidates: a rectangle that is cut out of all layers at once.
#pragma once
#include <algorithm>
#include <cstdint>

#include "engine/tiles/tile_layers.h"

namespace ilot {

struct PixelRect {
  std::int64_t x0 = INT64_MAX, y0 = INT64_MAX, x1 = INT64_MIN, y1 = INT64_MIN;  // closed
  void add(std::int64_t x, std::int64_t y) {
    x0 = std::min(x0, x), y0 = std::min(y0, y), x1 = std::max(x1, x), y1 = std::max(y1, y);
  }
  void add(const PixelRect& o) {
    x0 = std::min(x0, o.x0), y0 = std::min(y0, o.y0), x1 = std::max(x1, o.x1), y1 = std::max(y1, o.y1);
  }
  bool within(const PixelRect& o) const { return x0 >= o.x0 && y0 >= o.y0 && x1 <= o.x1 && y1 <= o.y1; }
  std::uint32_t width() const { return static_cast<std::uint32_t>(x1 - x0 + 1); }
  std::uint32_t height() const { return static_cast<std::uint32_t>(y1 - y0 + 1); }
};

// The layers of a rectangle and of one pixel around it.
struct Patch {
  std::int64_t x = 0, y = 0;  // of its first pixel
  Image height, range, accumulation, above, low, occupancy, components, beside;
};

Patch load_patch(const TileLayers& layers, const PixelRect& r);

// A smaller rectangle of a patch.
Patch cut(const Patch& p, const PixelRect& r);

}  // namespace ilot
