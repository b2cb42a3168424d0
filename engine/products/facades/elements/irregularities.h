// SPDX-License-Identifier: Apache-2.0
// Finds where a wall is not even: bulges and hollows of its render [Lorraine thesis, 4.1], as meshes [Lorraine thesis,
// 4.2.2].
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

struct IrregularityParams {
  double psi = 0.08;           // metres by which the threshold is widened: no irregularity is higher or deeper
  double least_area = 0.04;    // m2
  double least_density = 0.5;  // share of that of the wall, with the wide threshold; a sparser region is an element
  double most_flat = 0.8;      // largest share of its points at one depth: a band or a sill is flat, a bulge is not
};

// All lengths are in metres, in the axes of the wall.
struct Irregularity {
  std::vector<Place2> ring;                             // counter-clockwise
  std::vector<Vec3> vertices;                           // u, v, w
  std::vector<std::array<std::uint32_t, 3>> triangles;  // their normals point out of the wall
  double rise = 0, rise_error = 0;  // height of its highest point; negative: depth of its deepest point
  double density = 0;  // its points with the wide threshold, divided by those that the wall has on such an area
  std::uint64_t points = 0;
};

// Finds the small dense regions that the wall leaves out with its own threshold (delta, the epsilon of the site) and
// fills with delta + psi. A region that is dense at one depth only is relief and is left out here. So is a region that
// lies within `taken`: openings, sills, bands. A region grows from the seed with |w| > delta to the place where the
// mean height is no longer above the noise. For the mesh, the points are thinned to one per cell; it is their Delaunay
// triangulation in the plane of the wall, clipped to the outer ring of the alpha shape. The order is from bottom to
// top, and from left to right within a row. O(n log n).
std::vector<Irregularity> find_irregularities(const RaySamples& samples, const std::vector<Box2>& taken,
                                              const IrregularityParams& params = {});

}  // namespace ilot
