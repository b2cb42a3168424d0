// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/ring.h"

namespace ilot {

// Tells quickly whether points are inside of rings. The edges are kept in horizontal bands, and a query reads the edges
// of one band only. The even-odd rule applies. An edge includes its lower end and the points left of it, so exactly one
// of the regions that tile the plane contains a point. Coordinates are any finite numbers. Building is O(edges) for
// edges that are no longer than the bands are high. Memory is about 25 bytes per edge where each edge begins at the end
// of the one before it, and 40 bytes where none does.
class BandedRegion {
 public:
  BandedRegion() = default;
  // The edges of closed rings, in any order.
  explicit BandedRegion(std::span<const FlatEdge> edges);

  bool contains(FlatPoint p) const;

 private:
  std::size_t band_of(double y) const;

  double low_ = 0, bands_per_unit_ = 0;
  std::vector<std::uint32_t> first_;  // of each band, and the end of the last
  std::vector<std::uint32_t> edges_;  // in each band those that reach into it: their first ends in places_
  std::vector<FlatPoint> places_;     // ends of edges; the second end follows the first
};

}  // namespace ilot
