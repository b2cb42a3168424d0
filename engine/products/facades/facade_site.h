// SPDX-License-Identifier: Apache-2.0
// A facade's wall, its points and where it was seen from, all in the wall's own axes.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// u along the wall, v up, w out of it; unit length, right x up = out. The origin lies on the wall.
struct FacadeAxes {
  Vec3 origin, right, up, out;  // origin in CRS units
};

// Metres in the axes. `plane` is the id of the segment that the point lies on, 0 for none.
struct FacadePoint {
  float u = 0, v = 0, w = 0;
  std::uint32_t plane = 0;
};

// Metres in the axes; steps in radians, 0 when they are unknown.
struct FacadeStation {
  Vec3 position;
  double azimuth_step = 0, elevation_step = 0;
};

// A segment parallel to the wall, in front of it or behind.
struct ParallelPlane {
  std::uint32_t id = 0;
  std::uint64_t points = 0;
};

// In the wall's axes, metres.
struct Place2 {
  double u = 0, v = 0;
};

using OutlineRing = std::vector<Place2>;  // the last corner leads to the first

// Numbers of stations, from 1 on, and what else may stand there.
using SiteStation = std::uint16_t;
constexpr SiteStation kStationUnknown = 0;
constexpr SiteStation kStationNotInFront = 65535;  // one that is not in front of the wall: its rays do not cross it

struct FacadeSite {
  FacadeAxes axes;
  std::string crs;
  double metres_per_unit = 1;
  double width = 0, height = 0;         // metres: the wall lies in u 0 to width, v 0 to height
  double epsilon = 0.005;               // metres: farthest that points of the wall lie from it
  double noise = 0.002;                 // metres: root mean square of that
  double step = 0.02;                   // metres between its points
  std::vector<std::uint32_t> wall;      // ids of the segments that make up the wall
  std::vector<ParallelPlane> parallel;  // by id
  std::vector<OutlineRing> rings;   // outer ones of the wall's segments; none: the wall is taken to be its rectangle
  std::vector<FacadePoint> points;  // of the wall and around it
  std::vector<FacadeStation> stations;  // in front of the wall
  std::vector<SiteStation> from;        // per point the number of its station; empty: none is known
};

}  // namespace ilot
