// SPDX-License-Identifier: Apache-2.0
// The points of a facade as an orthoimage: a picture to scale that is placed under the drawing.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/model/facade.h"
#include "kernels/geometry/box3.h"

namespace ilot {

struct ImagePoint {
  Vec3 position;                         // CRS
  std::array<std::uint8_t, 3> colour{};  // of the point; where it has none, its intensity as a grey value
};

// Gives the points of the facade in a box, piece by piece, to its second argument. It may give other points too. For
// the same box it gives the same points each time, in any order and in pieces of any size. It is called two or three
// times for each part of a picture. Where parts are asked for (FacadeImageParams::tile), it is called for several parts
// at the same time.
using PointSource = std::function<void(const Box3<Vec3>& box, const std::function<void(std::span<const ImagePoint>)>&)>;

enum class ImageShade : std::uint8_t { colour, relief };  // relief: points nearer to the street are lighter

struct FacadeImageParams {
  double pixel_m = 0;  // 0: the mean distance between points where there are some, up to 1, 2 or 5 (2 mm or more)
  std::uint64_t most_pixels = std::uint64_t{1} << 24;  // the pixel size is doubled until these pixels are enough
  std::uint32_t tile = 0;              // pixels along a side of the parts that are computed in parallel; 0: one part
  double around_m = 0.25;              // margin beyond the elements
  double front_m = 1.5, behind_m = 1;  // points farther from the wall are left out
  double band_m = 0.03;                // the foremost points and those at most this far behind them give the colour
  int fill_rounds = 2;                 // gaps of up to twice this number of pixels are closed
  ImageShade shade = ImageShade::colour;
  double metres_per_unit = 1;
};

struct FacadeImage {
  std::uint32_t width = 0, height = 0;
  double pixel_m = 0;
  FlatBox place;                   // place in the drawing
  std::vector<std::uint8_t> rgba;  // rows from the top, four bytes a pixel, 0 0 0 0 where nothing is known
  std::uint64_t points = 0, filled = 0, empty = 0;
};

// Returns the picture of a facade around its elements or, without elements, over its width and height from its origin.
// Memory: 4 bytes a pixel, and 28 bytes a pixel for the tiles in work, one tile for each thread. The same points in any
// order give the same bytes with any tiles. O(points); each tile reads the points around it.
FacadeImage facade_image(const Facade& facade, const PointSource& source, const FacadeImageParams& params = {});

// Writes the PNG and beside it a world file (.pgw) in metres of the drawing. Each file is complete or absent. Throws
// Error.
void write_facade_image(const std::filesystem::path& path, const FacadeImage& image);

}  // namespace ilot
