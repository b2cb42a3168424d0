// SPDX-License-Identifier: Apache-2.0
// Images of points seen from above, and what morphology makes of them.
//
//   const ilot::Raster top = ilot::raster_of_points({x, y, z}, 0.2, ilot::PixelValue::highest);
//   const ilot::Raster closed = ilot::fill_short_gaps(top, 10, 0.2);
//
// Functions own nothing and keep nothing; several threads may call them at once. Morphology works on whole numbers:
// values are rounded to `resolution`, by which results differ from the exact ones by half of it at most; their
// magnitudes stay below 2^30 resolutions (a thousand kilometres at a millimetre). Error (usage) for values beyond that,
// for sizes that do not fit, and for rasters of 2^31 pixels or more.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

// Which pixels are neighbours: across sides, or across corners too.
enum class Adjacency : std::uint8_t { four, eight };

// Row by row from the south, each from the west. Pixel (column, row) covers x from x0 + column * pixel on, and y alike.
struct Raster {
  double x0 = 0, y0 = 0;  // of the south-western corner, CRS units
  double pixel = 1;       // width and height of a pixel, CRS units
  std::uint32_t width = 0, height = 0;
  std::vector<double> values;  // width x height; not a number = none
};

enum class PixelValue : std::uint8_t {
  highest,  // largest z in the pixel
  lowest,   // smallest z
  count,    // points, 0 where there are none
};

// Corners of pixels are at multiples of `pixel`; a point on a border belongs to the pixel north and east of it. O(n +
// pixels).
Raster raster_of_points(const PointArrays& points, double pixel, PixelValue value);

// Gaps between scan lines closed: a pixel without a value in a gap of its row or column of at most `longest` pixels,
// whose two ends differ by at most `step`, gets the value on the straight line between them, the lower one of both.
// O(pixels).
Raster fill_short_gaps(const Raster& raster, std::uint32_t longest, double step, double resolution = 0.001);

// Reconstruction by erosion of `mask` from `marker`: erosions of the marker that never fall below the mask, until
// nothing changes (Vincent 1993): fills what no path leads out of. A marker below the mask is raised to it; without a
// value it says nothing. Both of one size. O(pixels log pixels).
Raster reconstruct_by_erosion(const Raster& marker, const Raster& mask, Adjacency adjacency, double resolution = 0.001);

// Its dual, by dilations that never rise above the mask: cuts off what no marker reaches.
Raster reconstruct_by_dilation(const Raster& marker, const Raster& mask, Adjacency adjacency,
                               double resolution = 0.001);

// The relief is flooded from the markers (labels from 1, 0 elsewhere), one a pixel; every pixel goes to the basin that
// reaches it first (Meyer 1991). Returns a label a pixel; 0 where the relief has no value. O(pixels).
std::vector<std::uint32_t> watershed(const Raster& relief, std::span<const std::uint32_t> markers, Adjacency adjacency,
                                     double resolution = 0.001);

}  // namespace ilot
