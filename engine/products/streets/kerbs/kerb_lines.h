// SPDX-License-Identifier: Apache-2.0
// Lines of kerbs from the steps of the ground at single places.
#pragma once
#include <span>
#include <vector>

namespace ilot {

// A place on the upper edge of a step.
struct StepPoint {
  double x = 0, y = 0, z = 0;  // metres
  double up_x = 1, up_y = 0;   // unit vector across the edge, towards the upper surface
  double height = 0;           // metres
};

struct KerbVertex {
  double x = 0, y = 0, z = 0, height = 0;  // metres
};

struct KerbLine {
  bool seen = true;
  std::vector<KerbVertex> vertices;  // the upper surface is on the left
};

struct KerbLineParams {
  double spacing = 0.3;        // metres between places on one step
  double radius = 0.4;         // metres, of the windows in which they were found
  double least_length = 2;     // metres; shorter steps are no kerbs
  double smoothing = 1;        // metres along the line on both sides; vertices are means over it
  double longest_bridge = 12;  // metres that may be hidden, as by two cars
};

// Links places to lines. Each place has at most one successor: the nearest ahead that continues its edge and whose step
// is about as high; two places are linked where each is the other's choice. Places are then smoothed along their line
// by straight lines over some way, and vertices that change nothing are left out. Lines that continue each other within
// two windows are joined; a longer gap is bridged by a line that is not seen. The lines depend on the order of
// `places` only by their own order. O(n log n).
std::vector<KerbLine> link_kerbs(std::span<const StepPoint> places, const KerbLineParams& params);

}  // namespace ilot
