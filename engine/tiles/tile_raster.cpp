// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/tile_raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/error.h"
#include "engine/report/progress.h"
#include "kernels/core/integers.h"
#include "kernels/geometry/box3.h"

namespace ilot {
namespace {

// The least number of tiles between two sites. It is far more than any step examines beyond a tile (links of 10 m,
// lines of facades that continue in the next window of 200 m), for any pixel; at 5 cm it is 1.6 km.
constexpr std::int64_t kWidestGap = 64;
constexpr std::int64_t kMostPixels = (std::int64_t{1} << 31) - 1;  // in one direction

}  // namespace

double TileRaster::crs(const FoldedAxis& axis, double at) const {
  const auto tile = static_cast<std::int64_t>(std::floor(at / grid.side));
  const std::int64_t origin = (axis.lattice(tile) - tile) * grid.side;
  return (static_cast<double>(origin) + at) * static_cast<double>(pixel) * unit;
}

std::int64_t TileRaster::folded_pixel(const FoldedAxis& axis, std::int64_t lattice) const {
  const std::int64_t at = floor_divided(lattice, pixel), tile = floor_divided(at, grid.side);
  const std::int64_t folded = axis.folded(tile);
  return folded < 0 ? -1 : at + (folded - tile) * grid.side;
}

std::size_t TileRaster::tile_over(Index3 p) const {
  return grid.tile_at(rows.folded(floor_divided(p.y, tile_units())), columns.folded(floor_divided(p.x, tile_units())));
}

PointWindow TileRaster::window(std::size_t tile) const {
  const TilePlace place = grid.place(tile);
  return {rows.lattice(place.row), columns.lattice(place.column)};
}

IndexBox TileRaster::box(std::size_t tile, std::int64_t halo) const {
  const Index3 low = corner(tile);
  const std::int64_t around = halo * pixel, last = tile_units() - 1 + around;
  return column_over(low.x - around, low.y - around, low.x + last, low.y + last);
}

Index3 TileRaster::corner(std::size_t tile) const {
  const PointWindow at = window(tile);
  return {at.column * tile_units(), at.row * tile_units(), 0};
}

TileRaster plan_raster(const Store& store, const PassContext& context, std::int64_t pixel, std::uint32_t side,
                       const RasterUse& use) {
  TileRaster raster;
  raster.pixel = pixel;
  raster.unit = store.unit();
  const double metres = store.unit() * context.metres_per_unit;
  raster.scale = {metres, metres * static_cast<double>(pixel)};
  raster.grid.side = side;
  const std::vector<PointWindow> windows = windows_with_points(store, context, raster.tile_units());
  std::vector<std::int64_t> rows, columns;
  for (const auto& [row, column] : windows) rows.push_back(row), columns.push_back(column);
  std::sort(columns.begin(), columns.end());
  raster.rows = FoldedAxis(rows, kWidestGap);
  raster.columns = FoldedAxis(columns, kWidestGap);
  const std::int64_t width = raster.columns.size() * side, height = raster.rows.size() * side;
  if (std::max(width, height) > kMostPixels)
    throw Error(fmt::format(
        "{}: the points are spread over {} tiles of {:.0f} m that do not touch, which is more than a raster "
        "can contain: give {}or a part of them (--bounds)",
        use.what, grouped(windows.size()), side * raster.scale.pixel, use.remedy));
  raster.grid.width = static_cast<std::uint32_t>(width);
  raster.grid.height = static_cast<std::uint32_t>(height);
  for (const auto& [row, column] : windows)
    raster.grid.tiles.push_back({static_cast<std::uint32_t>(raster.rows.folded(row)),
                                 static_cast<std::uint32_t>(raster.columns.folded(column))});
  return raster;
}

}  // namespace ilot
