// SPDX-License-Identifier: Apache-2.0
// A raster over the points of a store, in tiles. Only tiles with points exist.
#pragma once
#include <cstdint>

#include "engine/pass/context.h"
#include "engine/store/store.h"
#include "engine/tiles/folded_axis.h"
#include "engine/tiles/point_windows.h"
#include "engine/tiles/raster_scale.h"
#include "engine/tiles/raster_use.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// The position of the images. A pixel is a whole number of lattice units, with corners at multiples of it; tiles have
// corners at multiples of their side. So all runs share one raster. Long stretches without a tile are left out of the
// numbers of pixels (FoldedAxis). Distances between sites that are this far apart are computed only in CRS coordinates.
struct TileRaster {
  std::int64_t pixel = 50;   // lattice units
  FoldedAxis columns, rows;  // of tiles
  RasterScale scale;
  double unit = 0.001;  // CRS units of a lattice unit
  TileGrid grid;

  double crs_x(double pixel_x) const { return crs(columns, pixel_x); }
  double crs_y(double pixel_y) const { return crs(rows, pixel_y); }
  // The pixel that contains a coordinate; -1 where there is none.
  std::int64_t column(std::int64_t lattice_x) const { return folded_pixel(columns, lattice_x); }
  std::int64_t row(std::int64_t lattice_y) const { return folded_pixel(rows, lattice_y); }
  // The tile that contains a point in plan; kNoTile where there is none.
  std::size_t tile_over(Index3 p) const;
  // The box of the lattice columns over a tile and over `halo` pixels around it.
  IndexBox box(std::size_t tile, std::int64_t halo = 0) const;
  // The window of a tile on the lattice of tiles.
  PointWindow window(std::size_t tile) const;
  // The corner of a tile's first pixel in lattice units.
  Index3 corner(std::size_t tile) const;
  std::int64_t tile_units() const { return pixel * grid.side; }

 private:
  double crs(const FoldedAxis& axis, double at) const;
  std::int64_t folded_pixel(const FoldedAxis& axis, std::int64_t lattice) const;
};

// Plans the raster of a store with pixels of `pixel` lattice units and tiles of `side` pixels. Throws Error, which
// begins with `use.what`, where there are so many tiles that their pixels cannot be numbered (2^31 in one direction).
// O(points).
TileRaster plan_raster(const Store& store, const PassContext& context, std::int64_t pixel, std::uint32_t side,
                       const RasterUse& use);

}  // namespace ilot
