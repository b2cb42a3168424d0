// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// nx x + ny y + d = 0 in pixels, centres of pixels at whole numbers; (nx, ny) of unit length, ny > 0 or ny = 0 < nx.
struct ImageLine {
  double nx = 0, ny = 1, d = 0;
};

struct HoughLine {
  ImageLine line;
  double weight = 0;        // sum of the pixels within max_distance of it
  double rms = 0;           // weighted distance of those, pixels
  std::uint32_t first = 0;  // of them, row by row: a point near the line
};

struct HoughLinesParams {
  std::uint32_t directions = 360;  // over half a turn
  double max_distance = 2;         // pixels, inclusive; a line's pixels
  std::uint32_t max_lines = 1;
  double least_share = 0.25;  // of the first line's votes that a further line has to have
};

// Lines of an image by a Hough transform weighted by the value of the pixel [Hernandez and Marcotegui 2008, 3.1]: each
// pixel above 0 votes with its value for the lines through it, in cells of one pixel in rho and half a turn /
// directions. The cell with most votes (ties: the lower direction, from x turning to y, then the lower rho) is refined:
// orthogonal least squares, weighted, of the pixels within max_distance, until the line stays (C3's loop, capped). Its
// pixels are taken out before the next line is sought. Strongest cells first. Cosines of portable arithmetic and whole
// votes: the same on every machine. O(directions x pixels above 0), directions in parallel; 8 bytes a cell. No pixel
// above 0: no line.
std::vector<HoughLine> hough_lines(const Image& weights, const HoughLinesParams& params = {});

}  // namespace ilot
