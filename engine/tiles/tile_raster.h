// SPDX-License-Identifier: Apache-2.0
// A raster over the points of a store, in tiles of which only those with points exist.
#pragma once
#include <cstdint>
#include <string>

#include "engine/pass/context.h"
#include "engine/store/store.h"
#include "engine/tiles/folded_axis.h"
#include "engine/tiles/point_windows.h"
#include "engine/tiles/raster_scale.h"
#include "kernels/rasters/tiles.h"

namespace ilot {

// Where the images are: pixels of whole lattice units with corners at multiples of them, tiles at multiples of their
// side, so that all runs share one raster. Long stretches without a tile are left out of the numbers of pixels
// (FoldedAxis); distances between sites that far apart are asked for nowhere but in CRS coordinates.
struct TileRaster {
  std::int64_t pixel = 50;   // lattice units
  FoldedAxis columns, rows;  // of tiles
  RasterScale scale;
  double unit = 0.001;  // CRS units of a lattice unit
  TileGrid grid;

  double crs_x(double pixel_x) const { return crs(columns, pixel_x); }
  double crs_y(double pixel_y) const { return crs(rows, pixel_y); }
  // The pixel that holds a coordinate; -1 where there is none.
  std::int64_t column(std::int64_t lattice_x) const { return folded_pixel(columns, lattice_x); }
  std::int64_t row(std::int64_t lattice_y) const { return folded_pixel(rows, lattice_y); }
  // The tile over a point, kNoTile where there is none.
  std::size_t tile_over(Index3 p) const;
  // The columns of the lattice over a tile and so many pixels around it.
  IndexBox box(std::size_t tile, std::int64_t halo = 0) const;
  // Of a tile on the lattice of tiles.
  PointWindow window(std::size_t tile) const;
  // Lattice units of a tile's first pixel.
  Index3 corner(std::size_t tile) const;
  std::int64_t tile_units() const { return pixel * grid.side; }

 private:
  double crs(const FoldedAxis& axis, double at) const;
  std::int64_t folded_pixel(const FoldedAxis& axis, std::int64_t lattice) const;
};

// The raster of a store with pixels of so many lattice units and tiles of `side` pixels. Throws Error, that begins with
// `what`, where tiles are so many that their pixels have no numbers (2^31 in a direction). O(points).
TileRaster plan_raster(const Store& store, const PassContext& context, std::int64_t pixel, std::uint32_t side,
                       const std::string& what);

}  // namespace ilot
