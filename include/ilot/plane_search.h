// SPDX-License-Identifier: Apache-2.0
// Planes of points in memory, as of one building or one room. For whole clouds, which need not fit into memory, see
// run.h.
//
//   const ilot::PlaneSearchResult found = ilot::find_planes({x, y, z}, {.epsilon = 0.02, .min_points = 200});
//   for (const ilot::Plane& p : found.segments.planes) std::printf("%g %g %g %g\n", p.n.x, p.n.y, p.n.z, p.d);
//
// Owns nothing, keeps nothing; several threads may call it at once.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

// What every method of plane extraction returns.
struct PlaneSegments {
  std::vector<std::uint32_t> label;  // per point: 0 = none, else 1 + index into planes
  std::vector<Plane> planes;         // unit normals that point up, in the frame of the points
};

// Lengths in the units of the coordinates. nullopt: chosen from the spacing and the noise of the points, where the unit
// is taken to be `metres_per_unit`.
struct PlaneSearchOptions {
  std::optional<double> epsilon = {};            // greatest distance of a labelled point from its plane
  std::optional<double> normal_angle_deg = {};   // between a point's normal and its plane's, 0 to 90
  std::optional<std::uint32_t> min_points = {};  // fewest points of a plane, at least 3
  std::optional<double> connectivity = {};       // points of one plane farther apart than this are two planes
  double probability = 0.99;                     // that no larger plane was overlooked when one is taken, below 1
  int normal_neighbours = 16;                    // that normals are estimated from, 3 to 64
  std::uint64_t seed = 0;                        // varies the random draws
  double metres_per_unit = 1;
  double step = 0;  // of the lattice (geometry.h); 0 = lattice_step(points)
  int threads = 0;  // 0 = all that the process may use; no result depends on it
};

struct PlaneSearchResult {
  PlaneSegments segments;                                                // the planes of the most points first
  double epsilon = 0, normal_angle_deg = 0, connectivity = 0, step = 0;  // that were used
  std::uint32_t min_points = 0;
};

// Random sample consensus, the largest plane first (Schnabel, Wahl and Klein 2007; refinement by least squares over the
// largest connected part). Equal input gives equal output, whatever the threads and the machine; another order of the
// points changes nothing but the order of their labels, as long as no two are at one place. Every labelled point lies
// within epsilon of its plane, as given and not only on the lattice. Points without a normal have no label. Thousands
// to some ten million points: O(draws n), about a second for a million points of a building; memory about 100 bytes a
// point. Error (usage) for options out of range, for an epsilon below three steps of the lattice, and what lattice_step
// refuses. Fewer than 16 points need all four options.
PlaneSearchResult find_planes(const PointArrays& points, const PlaneSearchOptions& options = {});

}  // namespace ilot
