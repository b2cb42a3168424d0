// SPDX-License-Identifier: Apache-2.0
// The images of a street on disk, and what is drawn in them from the points.
#pragma once
#include <algorithm>

#include "engine/pass/context.h"
#include "engine/products/streets/ground/raster_scale.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"
#include "engine/tiles/folded_axis.h"
#include "engine/tiles/packed_layers.h"
#include "engine/tiles/point_windows.h"
#include "engine/tiles/street_layers.h"
#include "engine/tiles/tile_runner.h"

namespace ilot {

// Where the images are: pixels of whole lattice units with corners at multiples of them, tiles at multiples of their
// side, so that all runs share one raster. Long stretches without a tile are left out of the numbers of pixels
// (FoldedAxis); distances between sites that far apart are asked for nowhere but in CRS coordinates.
struct StreetRaster {
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
  // Of a tile on the lattice of tiles.
  PointWindow window(std::size_t tile) const;
  // Lattice units of a tile's first pixel.
  Index3 corner(std::size_t tile) const;
  std::int64_t tile_units() const { return pixel * grid.side; }

 private:
  double crs(const FoldedAxis& axis, double at) const;
  std::int64_t folded_pixel(const FoldedAxis& axis, std::int64_t lattice) const;
};

// Heights of lattice points; what is farther from 0 than heights may be, as a stray point is, counts as just so far.
inline Height height_of(std::int64_t z) {
  constexpr std::int64_t kMost = (std::int64_t{1} << 30) - 1;
  return static_cast<Height>(std::clamp(z, -kMost, kMost));
}

// How many points cells of a square metre hold that hold any.
struct PointDensity {
  double median = 0;   // points a square metre
  double crowded = 0;  // share of all points that lie in cells with more than four times the median
};
PointDensity point_density(const Store& store, const PassContext& context);

// Who looks straight down gives each square metre about as many points; who goes along the street gives many times as
// many to what is upright or near. From the air, where less than a third of the points are crowded: of the clouds at
// hand 0 to 17 % are that were scanned from the air, an old town with its walls the most, and 72 to 91 % of those from
// vehicles.
StreetView view_of(const PointDensity& density);

// The pixel for a density, in multiples of 5 cm from 5 cm to 1 m. From the street half of the sampling step: what is
// upright fills its pixels many times. From the air one that holds a point with a probability of nine in ten, if points
// lie at random: things are then of one piece.
double pixel_for(double density, StreetView view);

class StreetTiles {
 public:
  // Plans the raster and draws "range" and "accumulation"; tiles without a point are absent. Throws Error where tiles
  // are so many that their pixels have no numbers (2^31 in a direction).
  StreetTiles(const Store& store, const PassContext& context, double pixel_metres);

  const StreetRaster& raster() const { return raster_; }
  const StreetLayers& layers() const { return layers_; }

  // Points of a pixel of the ground that has any, on average; 1 where there is none. Of "mask", "height",
  // "accumulation".
  double mean_accumulation() const;

  // "level": height of the ground in each pixel: below what stands on it, and within `reach` metres around it that of
  // the nearest of its pixels; kNoHeight beyond. Of "bare", which is dropped.
  void spread_level(double reach) const;

  // "above": points at least so many metres above the level, "low": those lower than low_height,
  // "occupancy": the bins (RasterScale::bin) that hold such points; none from the air, where no side is seen.
  void count_above(double least_height, double low_height, StreetView view) const;

 private:
  void plan();
  void draw(std::size_t tile);
  template <class Take>
  void for_points(std::size_t tile, const Take& take) const;

  const Store& store_;
  const PassContext& context_;
  StreetRaster raster_;
  PackedLayers packed_;
  TileRunner runner_;
  StreetLayers layers_;
};

}  // namespace ilot
