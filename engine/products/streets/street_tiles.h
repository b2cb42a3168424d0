// SPDX-License-Identifier: Apache-2.0
// The images of a street on disk, and what is drawn in them from the points.
#pragma once
#include <algorithm>
#include <functional>

#include "engine/pass/context.h"
#include "engine/products/streets/ground/cells.h"
#include "engine/products/streets/ground/standing_form.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"
#include "engine/tiles/raster_layers.h"

namespace ilot {

// Converts a lattice z to a height. A value whose magnitude exceeds the range of heights, as that of a stray can, is
// clamped to that range.
inline Height height_of(std::int64_t z) {
  constexpr std::int64_t kMost = (std::int64_t{1} << 30) - 1;
  return static_cast<Height>(std::clamp(z, -kMost, kMost));
}

// Statistics of the points per cell of one square metre, over the cells that contain points.
struct PointDensity {
  double median = 0;       // points a square metre
  double dense_share = 0;  // share of all points that lie in cells with more than four times the median
  double spread = 1;       // the 9th decile of the points of a cell divided by the 1st
};
PointDensity point_density(const Store& store, const PassContext& context);

// Decides from where a cloud was scanned. A scanner that looks straight down gives each square metre about the same
// number of points, and few of them. A scanner on the ground gives many times more points to what is upright or near.
// The view is from the air where less than a quarter of the points lie in dense cells, where the 9th decile of the
// points of a square metre is at most 20 times the 1st, and where the median is at most 200 points a square metre.
// bench/wild/history/streets.md has the values of our clouds.
StreetView view_of(const PointDensity& density);

// The size of a pixel for a density, in multiples of 5 cm from 5 cm to 1 m. From the street it is half of the sampling
// step: what is upright fills its pixels many times. From the air it is the size at which a pixel contains a point with
// a probability of nine in ten if the points lie at random: each object is then one connected component.
double pixel_for(double density, StreetView view);

// Choice: more than the height of a van. What is higher in a cell with a crown is the crown's.
constexpr double kClearance = 2.5;  // metres above the terrain

// Whether a point so high above the level was taken out with the crown or the overhang of its cell.
inline bool is_taken_out(Structure of_cell, Height above, Height clearance) {
  return is_overhead(of_cell) && above >= clearance;
}

// Receives each image of a tile before a step writes it. It is called from several threads at once.
using SeeTile = std::function<void(const TileRaster& raster, const char* layer, std::size_t tile, const Image& image)>;

// Plans the raster of a street with pixels of `pixel_metres`.
TileRaster street_raster(const Store& store, const PassContext& context, double pixel_metres);

class StreetTiles {
 public:
  // Plans the raster and the cells, for a density in points a square metre. Draws "range" and "accumulation" of pixels
  // and "lowest" of cells. Tiles without a point are absent. Throws Error where there are so many tiles that their
  // pixels cannot be numbered (2^31 in one direction).
  StreetTiles(const Store& store, const PassContext& context, double pixel_metres, double density, SeeTile see = {});

  const TileRaster& raster() const { return tiles_.raster(); }
  const TileLayers& layers() const { return layers_; }

  const Cells& cells() const { return cells_; }

  // Reads "terrain". Writes "shape" (StandingForm) and "top" (units above the terrain) of cells, and for pixels "clear"
  // and "clear points", the highest point below kClearance above the terrain and the number of points below it.
  void draw_heights(StreetView view) const;

  // Takes crowns and overhangs out of the images: in cells with one (the layer "structure") "range" and "accumulation"
  // become those of the points below kClearance. Drops what draw_heights wrote.
  void take_out_overhead() const;

  // The mean number of points of a ground pixel that has any; 1 where there is no such pixel. Reads "mask", "height"
  // and "accumulation".
  double mean_accumulation() const;

  // Writes "level", the height of the ground. In a pixel of the ground it is the height of "bare", which is the ground
  // without what stands on it. Within `reach` metres around the ground it is the level of the nearest ground pixel;
  // beyond that it is the terrain, and 0 of the "mask" becomes 2. Drops "bare".
  void spread_level(double reach) const;

  // Writes three layers. "above": the number of points at least least_height metres above the level. "low": the number
  // of those that are lower than low_height. "occupancy": the bins (RasterScale::bin) that contain such points.
  // Points in crowns are left out.
  void count_above(double least_height, double low_height) const;

 private:
  void draw(std::size_t tile);
  template <class Take>
  void for_points(std::size_t tile, const Take& take) const;

  const Store& store_;
  const PassContext& context_;
  RasterLayers tiles_;
  TileLayers layers_;
  Cells cells_;
};

}  // namespace ilot
