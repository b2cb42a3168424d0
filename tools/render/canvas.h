// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "kernels/core/types.h"
#include "tools/render/image.h"

namespace ilot::render {

// An orthographic view: where the eye stands, far away.
struct View {
  double azimuth_deg = 0;     // the way the eye looks, clockwise from north
  double elevation_deg = 90;  // of the eye above the horizon: 90 = from above, 0 = from the side
};

// Axes of the picture in world space, of unit length: to the right, upwards, towards the eye.
struct ViewAxes {
  Vec3 right, up, towards;
};
ViewAxes axes_of(const View& view);

// A picture with a depth buffer: the nearest point of each pixel wins, the first one drawn of equals.
class Canvas {
 public:
  Canvas(int width, int height);

  // A square of 2 radius + 1 pixels about (column, row); rows count downwards. Parts outside are cut off.
  // Larger depth is nearer.
  void draw(int column, int row, float depth, Rgb colour, int radius);

  // The picture with darkened edges where neighbours stand nearer (eye-dome lighting; Boucheny 2009); pixels
  // without a point are white. pixel: size of a pixel in units of depth.
  Image shaded(double pixel) const;

 private:
  float nearer_by(int column, int row, float limit) const;

  int width_, height_;
  std::vector<float> depth_;
  std::vector<Rgb> colour_;
};

}  // namespace ilot::render
