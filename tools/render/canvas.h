// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/core/types.h"
#include "tools/render/image.h"

namespace ilot::render {

// An orthographic view. The eye is infinitely far away.
struct View {
  double azimuth_deg = 0;     // direction in which the eye looks, clockwise from north
  double elevation_deg = 90;  // of the eye above the horizon: 90 = from above, 0 = from the side
};

// The axes of the picture in world space, of unit length: to the right, upwards, and towards the eye.
struct ViewAxes {
  Vec3 right, up, towards;
};
ViewAxes axes_of(const View& view);

// A picture with a depth buffer. In each pixel the nearest point wins. If depths are equal, the point that was drawn
// first wins.
class Canvas {
 public:
  Canvas(int width, int height);

  // Draws a square of 2 radius + 1 pixels around (column, row). Rows count downwards. Parts outside are cut off. A
  // larger depth is nearer.
  void draw(int column, int row, float depth, Rgb colour, int radius);

  // Returns the picture with darkened edges where neighbours are nearer (eye-dome lighting; Boucheny 2009). Pixels
  // without a point are white. `pixel` is the size of a pixel in units of depth.
  Image shaded(double pixel) const;

 private:
  float nearer_by(int column, int row, float limit) const;

  int width_, height_;
  std::vector<float> depth_;
  std::vector<Rgb> colour_;
};

}  // namespace ilot::render
