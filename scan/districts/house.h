// SPDX-License-Identifier: Apache-2.0
// A simple house: a rectangular box under a flat, gable or hip roof. It is convex and has no overhang.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/optics/exact_math.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// Values of the extra byte true_class.
enum class Surface : std::uint8_t { ground = 1, roof = 2, wall = 3, vegetation = 4 };

// The tilted plane on which everything stands: z = base + slope_x x + slope_y y.
struct Ground {
  double base = 0, slope_x = 0, slope_y = 0;
  double height(double x, double y) const { return base + slope_x * x + slope_y * y; }
  Plane plane() const;
};

enum class RoofShape : std::uint8_t { flat, gable, hip };
enum class Ridge : std::uint8_t { along_street, across_street };  // gable only; a hip's follows the longer side

struct HouseForm {
  double x = 0, y = 0;           // centre of the footprint
  SinCos heading;                // direction of the street
  double width = 8, depth = 10;  // along and across the street
  double eave = 6;               // absolute z of the eaves, or of the roof if it is flat
  RoofShape roof = RoofShape::gable;
  Ridge ridge = Ridge::along_street;
  double pitch_deg = 35;
};

// A flat, convex part of a surface.
struct Face {
  Surface surface = Surface::wall;
  Plane plane;             // outward
  std::vector<Vec3> ring;  // counter-clockwise seen from outside, not closed
};

// Returns the roof faces first, then the four walls, which reach from the ground to the roof. All coordinates are in
// the system of the form.
std::vector<Face> house_faces(const HouseForm& form, const Ground& ground);

// Returns the solid whose planes are the planes of the faces, in order. There may be at most ConvexSolid::kMaxFaces
// faces.
ConvexSolid house_solid(const std::vector<Face>& faces, std::uint32_t first_face);

// Returns the horizontal extent across the ridge of the roof. The height of the roof depends on it: rise = span / 2 *
// tan(pitch).
double roof_span(const HouseForm& form);

// Returns the horizontal distance from a position to the footprint. It is 0 inside.
double distance_to_footprint(const HouseForm& form, double x, double y);

}  // namespace ilot::scan
