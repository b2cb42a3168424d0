// SPDX-License-Identifier: Apache-2.0
// The images of a street on disk, and what is drawn in them from the points.
#pragma once
#include <algorithm>
#include <functional>

#include "engine/pass/context.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"
#include "engine/tiles/raster_layers.h"

namespace ilot {

// Heights of lattice points; what is farther from 0 than heights may be, as a stray point is, counts as just so far.
inline Height height_of(std::int64_t z) {
  constexpr std::int64_t kMost = (std::int64_t{1} << 30) - 1;
  return static_cast<Height>(std::clamp(z, -kMost, kMost));
}

// How many points cells of a square metre hold that hold any.
struct PointDensity {
  double median = 0;       // points a square metre
  double dense_share = 0;  // share of all points that lie in cells with more than four times the median
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

// Sees each image of a tile that a step writes, before it is written; from several threads at once.
using SeeTile = std::function<void(const TileRaster& raster, const char* layer, std::size_t tile, const Image& image)>;

// The raster of a street with pixels of so many metres.
TileRaster street_raster(const Store& store, const PassContext& context, double pixel_metres);

class StreetTiles {
 public:
  // Plans the raster and draws "range" and "accumulation"; tiles without a point are absent. Throws Error where tiles
  // are so many that their pixels have no numbers (2^31 in a direction).
  StreetTiles(const Store& store, const PassContext& context, double pixel_metres, SeeTile see = {});

  const TileRaster& raster() const { return tiles_.raster(); }
  const TileLayers& layers() const { return layers_; }

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
  void draw(std::size_t tile);
  template <class Take>
  void for_points(std::size_t tile, const Take& take) const;

  const Store& store_;
  const PassContext& context_;
  RasterLayers tiles_;
  TileLayers layers_;
};

}  // namespace ilot
