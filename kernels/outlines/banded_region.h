// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/ring.h"

namespace ilot {

// Tells quickly whether places lie inside of rings: their edges by level bands, a question looks at those of one band.
// Even-odd rule; an edge owns its lower end and what lies left of it, so that of regions that tile the plane exactly
// one holds a place. Any finite coordinates. O(edges) to build for edges as short as the bands are high; some 25 bytes
// an edge where each begins at the end of the one before it, 40 where none does.
class BandedRegion {
 public:
  BandedRegion() = default;
  // The edges of closed rings, in any order.
  explicit BandedRegion(std::span<const FlatEdge> edges);

  bool contains(FlatPoint p) const;

 private:
  std::size_t band_of(double y) const;

  double low_ = 0, bands_per_unit_ = 0;
  std::vector<std::uint32_t> first_;  // of each band, and the end
  std::vector<std::uint32_t> edges_;  // in each band those that reach into it: where their first ends are
  std::vector<FlatPoint> places_;     // ends of edges; the second is behind the first
};

}  // namespace ilot
