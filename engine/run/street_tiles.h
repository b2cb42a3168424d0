// SPDX-License-Identifier: Apache-2.0
// The images of a street on disk, and what is drawn in them from the points.
#pragma once
#include "engine/pass/context.h"
#include "engine/run/packed_layers.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"
#include "engine/streets/raster_scale.h"
#include "engine/streets/street_layers.h"

namespace ilot {

// Where the images lie: pixels of whole lattice units with corners at multiples of them, tiles at multiples of their
// side, so that all runs share one raster.
struct StreetRaster {
  std::int64_t pixel = 50;    // lattice units
  std::int64_t x = 0, y = 0;  // of the first pixel, in pixels
  RasterScale scale;
  double unit = 0.001;  // CRS units of a lattice unit
  TileGrid grid;

  double crs_x(double pixel_x) const { return (static_cast<double>(x) + pixel_x) * static_cast<double>(pixel) * unit; }
  double crs_y(double pixel_y) const { return (static_cast<double>(y) + pixel_y) * static_cast<double>(pixel) * unit; }
  std::int64_t column(std::int64_t lattice_x) const { return floor_divided(lattice_x) - x; }
  std::int64_t row(std::int64_t lattice_y) const { return floor_divided(lattice_y) - y; }

 private:
  std::int64_t floor_divided(std::int64_t v) const { return v >= 0 ? v / pixel : -((pixel - 1 - v) / pixel); }
};

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
  // Plans the raster and draws "range" and "accumulation"; tiles without a point are absent.
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
  void draw(std::size_t tile, std::vector<std::uint8_t>& present);
  template <class Take>
  void for_points(std::size_t tile, const Take& take) const;

  const Store& store_;
  const PassContext& context_;
  StreetRaster raster_;
  PackedLayers packed_;
  StreetLayers layers_;
};

}  // namespace ilot
