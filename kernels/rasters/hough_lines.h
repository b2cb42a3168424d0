// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// The line nx x + ny y + d = 0 in pixels. Centres of pixels are at whole numbers. (nx, ny) has unit length, with ny > 0
// or ny = 0 < nx.
struct ImageLine {
  double nx = 0, ny = 1, d = 0;
};

struct HoughLine {
  ImageLine line;
  double weight = 0;        // sum of the pixels within max_distance of it
  double rms = 0;           // weighted root mean square distance of these pixels, in pixels
  std::uint32_t first = 0;  // first of these pixels, row by row: a point near the line
};

struct HoughLinesParams {
  std::uint32_t directions = 360;  // over half a turn
  double max_distance = 2;         // pixels, inclusive; distance of the pixels of a line
  std::uint32_t max_lines = 1;
  double least_share = 0.25;  // fewest votes of a further line, as a share of the votes of the first line
};

// Finds lines of an image by a Hough transform that is weighted by the value of the pixel [Hernandez and Marcotegui
// 2008, 3.1]. Each pixel above 0 votes with its value for the lines through it, in cells of one pixel in rho and half a
// turn / directions. The cell with most votes (ties: the lower direction, from x turning to y, then the lower rho) is
// refined by weighted orthogonal least squares of the pixels within max_distance, until the line no longer changes
// (C3's loop, with a limit on the rounds). Its pixels are removed before the next line is sought. The strongest cells
// come first. Cosines use portable arithmetic and votes are integers, so the result is the same on every machine.
// O(directions x pixels above 0), with directions in parallel; 8 bytes per cell. Without a pixel above 0 there is no
// line.
std::vector<HoughLine> hough_lines(const Image& weights, const HoughLinesParams& params = {});

}  // namespace ilot
