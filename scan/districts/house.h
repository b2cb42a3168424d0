// SPDX-License-Identifier: Apache-2.0
// A simple house: a rectangular box under a flat, gable or hip roof. Convex, without overhang.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/optics/exact_math.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// Values of the extra byte true_class.
enum class Surface : std::uint8_t { ground = 1, roof = 2, wall = 3, vegetation = 4 };

// The tilted plane everything stands on, z = base + slope_x x + slope_y y.
struct Ground {
  double base = 0, slope_x = 0, slope_y = 0;
  double height(double x, double y) const { return base + slope_x * x + slope_y * y; }
  Plane plane() const;
};

enum class RoofShape : std::uint8_t { flat, gable, hip };
enum class Ridge : std::uint8_t { along_street, across_street };  // gable only; a hip's runs along the longer side

struct HouseForm {
  double x = 0, y = 0;           // centre of the footprint
  SinCos heading;                // direction of the street
  double width = 8, depth = 10;  // along and across the street
  double eave = 6;               // z of the eaves (flat: of the roof), absolute
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

// Roof faces first, then the four walls, from the ground to the roof. All coordinates as in the form.
std::vector<Face> house_faces(const HouseForm& form, const Ground& ground);

// The solid whose planes are the faces' planes, in order. At most ConvexSolid::kMaxFaces faces.
ConvexSolid house_solid(const std::vector<Face>& faces, std::uint32_t first_face);

// The horizontal extent across the ridge of the roof, on which its height depends: rise = span / 2 *
// tan(pitch).
double roof_span(const HouseForm& form);

// Distance in the plane from a place to the footprint; 0 inside.
double distance_to_footprint(const HouseForm& form, double x, double y);

}  // namespace ilot::scan
