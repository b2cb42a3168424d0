// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_places.h"

#include <cmath>

namespace ilot {
namespace {

// Choice: the accuracy of maps of posts; candidates farther from a place are another object.
constexpr double kNear = 0.5;  // metres; greatest distance from a place to its candidate

}  // namespace

std::uint32_t part_at(const FoundStreet& street, Vec3 place) {
  const TileRaster& raster = street.tiles->raster();
  const auto pixel_of = [&](double v) {
    return static_cast<std::int64_t>(std::floor(v / raster.unit / static_cast<double>(raster.pixel)));
  };
  const std::int64_t x = raster.column(pixel_of(place.x) * raster.pixel),
                     y = raster.row(pixel_of(place.y) * raster.pixel);
  const auto reach = std::int64_t{raster.scale.pixels(kNear)};
  if (!raster.grid.contains(x, y)) return 0;
  const auto side = static_cast<std::uint32_t>(2 * reach + 1);
  const Image candidates = layer_window(street.tiles->layers(), "candidates", x - reach, y - reach, side, side);
  std::uint32_t best = 0;
  std::int64_t nearest = reach * reach + 1;
  for (std::int64_t v = 0; v < side; ++v)
    for (std::int64_t u = 0; u < side; ++u) {
      const Height candidate = candidates.values[static_cast<std::size_t>(v * side + u)];
      const std::int64_t d = (u - reach) * (u - reach) + (v - reach) * (v - reach);
      if (candidate > 0 && d < nearest) nearest = d, best = static_cast<std::uint32_t>(candidate);
    }
  return best;
}

}  // namespace ilot
