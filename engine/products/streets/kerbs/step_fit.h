// SPDX-License-Identifier: Apache-2.0
// A step of the ground at one place.
#pragma once
#include <optional>
#include <span>

namespace ilot {

// A point of the ground, relative to the middle of the window in which a step is sought.
struct GroundPoint {
  double x = 0, y = 0, z = 0;  // metres
};

struct StepFitParams {
  double radius = 0.4;    // metres, of the window
  double lowest = 0.03;   // metres; lower steps are no kerbs
  double highest = 0.30;  // metres; higher ones are stairs and walls
};

// A step through a window. (x, y) is the point of its upper edge that is nearest to the middle.
struct StepFit {
  double x = 0, y = 0, z = 0;  // z: of the upper surface at the edge
  double up_x = 1, up_y = 0;   // unit vector across the edge, towards the upper surface
  double height = 0;           // metres, of the upper surface above the lower one at the edge
  double rms = 0;              // metres, of the points to both surfaces
};

// Finds the straight step that parts the points best: of all lines through the window, the one for which a plane with a
// step along the line leaves the least squares. Then a plane is fitted to each side. There is no step where a side has
// too few points or no surface of its own (as the foot of a wall), where both surfaces are not about parallel, or where
// the step is not much larger than what is uneven. `points` lie within the radius. O(points).
std::optional<StepFit> fit_step(std::span<const GroundPoint> points, const StepFitParams& params);

}  // namespace ilot
