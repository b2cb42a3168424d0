// SPDX-License-Identifier: Apache-2.0
// The wall of a facade, its points and the stations that saw it, all in the axes of the wall.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// u is along the wall, v is up, w is out of it. The vectors have unit length, and right x up = out. The origin is on
// the wall.
struct FacadeAxes {
  Vec3 origin, right, up, out;  // origin in CRS units
};

// The coordinates are in metres in the axes. `plane` is the id of the segment that contains the point; 0 for none.
struct FacadePoint {
  float u = 0, v = 0, w = 0;
  std::uint32_t plane = 0;
};

// The position is in metres in the axes. The steps are in radians; 0 when they are unknown.
struct FacadeStation {
  Vec3 position;
  double azimuth_step = 0, elevation_step = 0;
};

// A segment parallel to the wall, in front of it or behind it.
struct ParallelPlane {
  std::uint32_t id = 0;
  std::uint64_t points = 0;
};

// A place in the axes of the wall, in metres.
struct Place2 {
  double u = 0, v = 0;
};

using OutlineRing = std::vector<Place2>;  // the last corner leads to the first

// The number of a station, from 1 on, or one of the two special values below.
using SiteStation = std::uint16_t;
constexpr SiteStation kStationUnknown = 0;
constexpr SiteStation kStationNotInFront = 65535;  // not in front of the wall: its rays do not cross the wall

struct FacadeSite {
  FacadeAxes axes;
  std::string crs;
  double metres_per_unit = 1;
  double width = 0, height = 0;         // metres: the wall covers u from 0 to width and v from 0 to height
  double epsilon = 0.005;               // metres: greatest distance of points of the wall from it
  double noise = 0.002;                 // metres: root mean square distance of its points from it
  double step = 0.02;                   // metres between its points
  std::vector<std::uint32_t> wall;      // ids of the segments that make up the wall
  std::vector<ParallelPlane> parallel;  // by id
  std::vector<OutlineRing> rings;       // outer rings of its segments; none: the wall is taken to be its rectangle
  std::vector<FacadePoint> points;      // points of the wall and around it
  std::vector<FacadeStation> stations;  // the stations in front of the wall
  std::vector<SiteStation> from;        // number of the station of each point; empty: no station is known
};

}  // namespace ilot
