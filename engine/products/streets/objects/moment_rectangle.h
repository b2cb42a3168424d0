// SPDX-License-Identifier: Apache-2.0
// The rectangle that has the moments of a set of pixels.
#pragma once

namespace ilot {

struct MomentRectangle {
  double length = 0, width = 0, heading_deg = 0;  // heading of the length, from x towards y, 0 to below 180
};

// From the variances and the covariance of the middles of pixels, in pixels. `pixel` is the side of one, in the unit of
// the result: a single pixel has this length and width.
MomentRectangle moment_rectangle(double xx, double xy, double yy, double pixel);

}  // namespace ilot
