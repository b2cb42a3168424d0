// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/structures_beside.h"

namespace ilot {
namespace {

bool is_building(Height structure) {
  return structure == static_cast<Height>(Structure::wall) || structure == static_cast<Height>(Structure::roof);
}

}  // namespace

Image structures_beside(const Cells& cells, std::size_t tile) {
  const double side = cells.scale.pixel;
  const auto reach = static_cast<std::int64_t>(kBesideReach / side);
  const Image around = layer_around(cells.layers, "structure", tile, static_cast<std::uint32_t>(reach));
  // Squares of distances along the rows first, then the least sum over the columns.
  const auto w = static_cast<std::int64_t>(around.width), h = static_cast<std::int64_t>(around.height);
  const std::int64_t none = (reach + 1) * (reach + 1);
  std::vector<std::int64_t> along(around.size(), none);
  for (std::int64_t y = 0; y < h; ++y)
    for (std::int64_t x = 0; x < w; ++x) {
      if (!is_building(around.values[static_cast<std::size_t>(y * w + x)])) continue;
      for (std::int64_t u = std::max<std::int64_t>(0, x - reach); u <= std::min(w - 1, x + reach); ++u) {
        std::int64_t& known = along[static_cast<std::size_t>(y * w + u)];
        known = std::min(known, (u - x) * (u - x));
      }
    }
  Image out = filled_image(cells.side(), cells.side(), 0);
  for (std::int64_t y = reach; y + reach < h; ++y)
    for (std::int64_t x = reach; x + reach < w; ++x) {
      std::int64_t least = none;
      for (std::int64_t v = y - reach; v <= y + reach; ++v)
        least = std::min(least, along[static_cast<std::size_t>(v * w + x)] + (v - y) * (v - y));
      const Height own = around.values[static_cast<std::size_t>(y * w + x)];
      auto structure = own == kNoHeight ? Structure::none : static_cast<Structure>(own);
      if (is_overhang(structure)) structure = Structure::overhang;
      const double metres = std::min(kBesideReach, side * std::sqrt(static_cast<double>(least)));
      out.values[static_cast<std::size_t>((y - reach) * cells.side() + x - reach)] =
          StructuresBeside(structure, metres).value();
    }
  return out;
}

}  // namespace ilot
