// SPDX-License-Identifier: Apache-2.0
// A facade's points as an orthoimage: a picture to scale that lies under the drawing.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "engine/deliverables/drawing.h"
#include "engine/model/facade.h"

namespace ilot {

struct ImagePoint {
  Vec3 position;                         // CRS
  std::array<std::uint8_t, 3> colour{};  // of the point; its intensity as a grey where it has none
};

// Gives all points of the facade, piece by piece, to what it is called with. It is called two or three times and
// gives the same points each time, in any order and in pieces of any size.
using PointSource = std::function<void(const std::function<void(std::span<const ImagePoint>)>&)>;

enum class ImageShade : std::uint8_t { colour, relief };  // relief: the nearer to the street, the lighter

struct FacadeImageParams {
  double pixel_m = 0;  // 0: as wide as points lie apart in the mean, rounded up to 1, 2 or 5 (2 mm or more)
  std::uint64_t most_pixels = std::uint64_t{1} << 24;  // 24 bytes each in memory; pixels are doubled until they suffice
  double around_m = 0.25;                              // beyond the elements
  double front_m = 1.5, behind_m = 1;                  // points farther off the wall are left out
  double band_m = 0.03;  // the foremost points and those so far behind them give the colour
  int fill_rounds = 2;   // gaps of up to twice as many pixels are closed
  ImageShade shade = ImageShade::colour;
  double metres_per_unit = 1;
};

struct FacadeImage {
  std::uint32_t width = 0, height = 0;
  double pixel_m = 0;
  DrawingBox place;                // in the drawing
  std::vector<std::uint8_t> rgba;  // rows from the top, four bytes a pixel, 0 0 0 0 where nothing is known
  std::uint64_t points = 0, filled = 0, empty = 0;
};

// The picture of a facade about its elements, or without any about its width and height from its origin. Memory is that
// of the pixels. The same points in any order give the same bytes.
FacadeImage facade_image(const Facade& facade, const PointSource& source, const FacadeImageParams& params = {});

// The PNG, and beside it a world file (.pgw) in metres of the drawing. Each is whole or absent. Throws Error.
void write_facade_image(const std::filesystem::path& path, const FacadeImage& image);

}  // namespace ilot
