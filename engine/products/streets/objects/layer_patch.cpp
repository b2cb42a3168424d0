// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/layer_patch.h"

namespace ilot {
namespace {

Image cut(const Image& image, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
  Image out{width, height, {}};
  out.values.reserve(std::size_t{width} * height);
  for (std::uint32_t v = y; v < y + height; ++v) {
    const auto row = image.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{v} * image.width + x);
    out.values.insert(out.values.end(), row, row + width);
  }
  return out;
}

}  // namespace

Patch load_patch(const TileLayers& layers, const PixelRect& r) {
  const auto read = [&](const char* layer) {
    return layer_window(layers, layer, r.x0 - 1, r.y0 - 1, r.width() + 2, r.height() + 2);
  };
  return {r.x0 - 1,      r.y0 - 1,    read("standing"),  read("range"),      read("accumulation"),
          read("above"), read("low"), read("occupancy"), read("components"), read("beside")};
}

Patch cut(const Patch& p, const PixelRect& r) {
  const auto x = static_cast<std::uint32_t>(r.x0 - 1 - p.x), y = static_cast<std::uint32_t>(r.y0 - 1 - p.y);
  const auto part = [&](const Image& image) { return cut(image, x, y, r.width() + 2, r.height() + 2); };
  return {r.x0 - 1,      r.y0 - 1,    part(p.height),    part(p.range),      part(p.accumulation),
          part(p.above), part(p.low), part(p.occupancy), part(p.components), part(p.beside)};
}

}  // namespace ilot
