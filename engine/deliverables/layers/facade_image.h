// SPDX-License-Identifier: Apache-2.0
// A facade's points as an orthoimage: a picture to scale that lies under the drawing.
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
  std::array<std::uint8_t, 3> colour{};  // of the point; its intensity as a grey where it has none
};

// Gives the facade's points in a box, and others if it likes, piece by piece, to what it is called with: the same
// points each time that it is asked for a box, in any order and in pieces of any size. It is called for each part of a
// picture two or three times; for several parts at once where these are asked for (FacadeImageParams::tile).
using PointSource = std::function<void(const Box3<Vec3>& box, const std::function<void(std::span<const ImagePoint>)>&)>;

enum class ImageShade : std::uint8_t { colour, relief };  // relief: the nearer to the street, the lighter

struct FacadeImageParams {
  double pixel_m = 0;  // 0: as wide as points lie apart in the mean, rounded up to 1, 2 or 5 (2 mm or more)
  std::uint64_t most_pixels = std::uint64_t{1} << 24;  // pixels are doubled until they suffice
  std::uint32_t tile = 0;  // pixels along a side of the parts that the picture is made of, in parallel; 0: one part
  double around_m = 0.25;  // beyond the elements
  double front_m = 1.5, behind_m = 1;  // points farther off the wall are left out
  double band_m = 0.03;                // the foremost points and those so far behind them give the colour
  int fill_rounds = 2;                 // gaps of up to twice as many pixels are closed
  ImageShade shade = ImageShade::colour;
  double metres_per_unit = 1;
};

struct FacadeImage {
  std::uint32_t width = 0, height = 0;
  double pixel_m = 0;
  FlatBox place;                   // in the drawing
  std::vector<std::uint8_t> rgba;  // rows from the top, four bytes a pixel, 0 0 0 0 where nothing is known
  std::uint64_t points = 0, filled = 0, empty = 0;
};

// The picture of a facade about its elements, or without any about its width and height from its origin. Memory: 4
// bytes a pixel, and 28 for those of the tiles in work, one a thread. The same points in any order give the same bytes,
// whatever the tiles. O(points), each tile reads what lies about it.
FacadeImage facade_image(const Facade& facade, const PointSource& source, const FacadeImageParams& params = {});

// The PNG, and beside it a world file (.pgw) in metres of the drawing. Each is whole or absent. Throws Error.
void write_facade_image(const std::filesystem::path& path, const FacadeImage& image);

}  // namespace ilot
