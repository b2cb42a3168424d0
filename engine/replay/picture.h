// SPDX-License-Identifier: Apache-2.0
// The drawing of a step, in metres of a plan or of the axes of a wall; tools/render/plot.h draws it.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/geometry/flat.h"

namespace ilot {

using PictureColour = std::array<std::uint8_t, 3>;

struct PicturePoint {
  FlatPoint at;
  PictureColour colour{};
};

// The nearness of a place to the eye: x * gx + y * gy + c; larger is nearer.
struct PictureDepth {
  double gx = 0, gy = 0, c = 0;
  double at(FlatPoint p) const { return p.x * gx + p.y * gy + c; }
};

struct PictureArea {
  std::vector<std::vector<FlatPoint>> rings;  // a place is filled when an odd number of rings encloses it
  PictureColour colour{}, edge{};
  PictureDepth depth{};  // the nearer of two areas covers the other; for equal ones the later
};

struct PictureLine {
  std::vector<FlatPoint> points;
  PictureColour colour{};
  bool dashed = false;  // for surroundings: it does not widen the picture
};

// Square pixels from the upper left corner; pixels where `shown` is 0 keep the colour of the paper.
struct PictureRaster {
  FlatPoint corner;  // upper left
  double pixel = 1;  // metres
  std::uint32_t width = 0, height = 0;
  std::vector<PictureColour> colours;
  std::vector<std::uint8_t> shown;
};

struct PictureWord {
  PictureColour colour{};
  std::string text;
};

// Drawn in the order of the members: later ones are above earlier ones.
struct Picture {
  std::string name;   // of the file, without extension
  std::string title;  // ASCII
  std::vector<PictureRaster> rasters;
  std::vector<PictureArea> areas;
  std::vector<PicturePoint> points;
  std::vector<PictureLine> lines;
  std::vector<PictureWord> legend;
  bool scale = true;  // a scale bar
};

// Returns colours that differ clearly for consecutive numbers, light ones for areas. 0 gives grey.
PictureColour colour_of_number(std::uint64_t number);
PictureColour light(PictureColour colour);

constexpr PictureColour kInk{30, 30, 30}, kGrey{150, 150, 150}, kPale{215, 215, 215}, kRed{200, 40, 40},
    kBlue{40, 80, 200}, kGreen{50, 150, 70}, kBrown{150, 110, 60};

}  // namespace ilot
