// SPDX-License-Identifier: Apache-2.0
// The planes that a run found, read back from its folder. Coordinates in the CRS of the inputs and its units; names
// that end in _m, _m2 and _deg are metres, square metres and degrees whatever the CRS.
//
//   const ilot::PlaneSet set = ilot::read_planes("out");
//   for (const ilot::Segment& s : set.segments) std::printf("%u: %g m2\n", s.id, s.area_m2);
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

// A plane and what is known of the points that lie on it. Coordinates in the CRS of the inputs.
struct Segment {
  std::uint32_t id = 0;          // dense from 1 within a run
  std::uint64_t content_id = 0;  // of the set of points: equal in every run that finds the same points
  Plane plane;                   // world coordinates and CRS units; unit normal, pointing up
  std::uint64_t points = 0;
  Vec3 centroid;
  Vec3 min, max;                 // of the points
  double rms_m = 0;              // distance of the points from the plane
  double epsilon_m = 0;          // none is farther
  double area_m2 = 0;            // of its outline, holes left out; 0 without an outline
  double level_m = 0;            // extent of its points along the horizontal direction in the plane
  double up_m = 0;               // and along the direction of steepest ascent; of a level plane: east and north
  double normal_spread_deg = 0;  // root mean square (of the sine) of the angles between its points' normals and its own
  double confidence = 0;         // share of its points that lie within half of epsilon and whose normals lean less than
                                 // 25 degrees from its own: about 0.9 where all is noise, below 0.1 where it only
                                 // happens to pass by
  std::uint32_t colour_class = 0;  // that most of its points have (ties: the smaller); 0 without colours
  std::uint32_t neighbours = 0;    // planes that touch it
};

// How two planes that touch lie to each other.
enum class Touching : std::uint8_t {
  edge,  // they lean by 5 degrees or more: they meet in a line
  step,  // they do not: one lies above or beside the other
};

struct PlaneNeighbours {
  std::uint32_t a = 0, b = 0;  // ids, a < b
  Touching touching = Touching::edge;
  double contact_m = 0;  // length along which they touch, to about the connectivity
  double angle_deg = 0;  // between their normals, 0 to 90
  double step_m = 0;     // of a step: how far b lies beyond a along a's normal, where they touch
  Vec3 place;            // CRS units: of an edge, the point of its line nearest to where they touch; of a step, on a
  Vec3 direction;        // of an edge: its line's, unit length, pointing up; of a step: zero
};

// The boundary of a segment on its plane. Coordinates in the CRS of the inputs.
struct Outline {
  using Ring = std::vector<Vec3>;  // from the last vertex an edge leads to the first
  using Part = std::vector<Ring>;  // the outer ring, then its holes
  std::uint32_t plane_id = 0;
  std::vector<Part> parts;  // none when the segment's points are too far apart
};

struct PlaneSet {
  std::vector<Segment> segments;            // by id: segment i has id i + 1
  std::vector<PlaneNeighbours> neighbours;  // by a, then b
  std::vector<Outline> outlines;            // one a segment, in the same order
};

// Reads planes.csv, planes_neighbours.csv and planes.gpkg of a run with the product planes. All is held in memory:
// about 300 bytes a plane, 24 a vertex. O(bytes). Several threads may read at once, folders are not changed. Error
// (usage) when there are no planes in the folder; a damaged file is an Error that names it.
PlaneSet read_planes(const std::filesystem::path& run_folder);

}  // namespace ilot
