// SPDX-License-Identifier: Apache-2.0
// What is to be drawn of a step, in metres of a plan or of a wall's axes; tools/render/plot.h draws it.
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

// How near to the eye a place is: x * gx + y * gy + c, larger is nearer.
struct PictureDepth {
  double gx = 0, gy = 0, c = 0;
  double at(FlatPoint p) const { return p.x * gx + p.y * gy + c; }
};

struct PictureArea {
  std::vector<std::vector<FlatPoint>> rings;  // filled where an odd number of them encloses
  PictureColour colour{}, edge{};
  PictureDepth depth{};  // of areas the nearer one hides the other; of equals the later one
};

struct PictureLine {
  std::vector<FlatPoint> points;
  PictureColour colour{};
  bool dashed = false;  // of what is around: it does not widen the picture
};

// Square pixels from the upper left corner; pixels where `shown` is 0 stay as the paper.
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

// Drawn in the order of the members: what comes later lies over what came before.
struct Picture {
  std::string name;   // of the file, without ending
  std::string title;  // ASCII
  std::vector<PictureRaster> rasters;
  std::vector<PictureArea> areas;
  std::vector<PicturePoint> points;
  std::vector<PictureLine> lines;
  std::vector<PictureWord> legend;
  bool scale = true;  // a scale bar
};

// Colours that are far apart for numbers that follow each other; light ones for areas. 0: grey.
PictureColour colour_of_number(std::uint64_t number);
PictureColour light(PictureColour colour);

constexpr PictureColour kInk{30, 30, 30}, kGrey{150, 150, 150}, kPale{215, 215, 215}, kRed{200, 40, 40},
    kBlue{40, 80, 200}, kGreen{50, 150, 70}, kBrown{150, 110, 60};

}  // namespace ilot
