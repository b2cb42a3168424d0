// SPDX-License-Identifier: Apache-2.0
// Where a wall is not even: bulges and hollows of its render [Lorraine thesis, 4.1], as meshes [Lorraine
// thesis, 4.2.2].
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

struct IrregularityParams {
  double psi = 0.08;           // metres that the threshold widens by: no irregularity is higher or deeper
  double least_area = 0.04;    // m2
  double least_density = 0.5;  // of the wall's own around it, with the wide threshold: else it is an element
  double most_flat = 0.8;      // share of its points on one depth: a band or a sill is flat, a bulge is not
};

// Metres in the wall's axes.
struct Irregularity {
  std::vector<Place2> ring;                             // counter-clockwise
  std::vector<Vec3> vertices;                           // u, v, w
  std::vector<std::array<std::uint32_t, 3>> triangles;  // turn out of the wall
  double rise = 0, rise_error = 0;                      // of its highest point; negative: its deepest
  double density = 0;  // points with the wide threshold, of those that the wall has on such an area
  std::uint64_t points = 0;
};

// The regions that the wall with its own threshold (delta, the site's epsilon) leaves out, and with delta + psi fills:
// dense and small. What is dense at one depth only is relief and left to it, and so is what lies within `taken`:
// openings, sills, bands. From the seed with |w| > delta the region grows to where the mean height sinks into the
// noise. The mesh: points thinned to one a cell, their Delaunay triangulation in the wall's plane, clipped to the
// alpha shape's outer ring. Left to right within bottom up. O(n log n).
std::vector<Irregularity> find_irregularities(const RaySamples& samples, const std::vector<Box2>& taken,
                                              const IrregularityParams& params = {});

}  // namespace ilot
