// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/units/unit_stretches.h"

namespace ilot {

// A point that was kept.
struct KeptPoint {
  StorePlace place;
  Index3 position;
};

// Takes the points of a unit one by one and keeps at most `most` of them: one in each cube of a lattice that starts at
// the corner of the unit. The edge of the cubes is the smallest power of two (lattice units) with which at most `most`
// cubes are occupied. In each cube the point with the smallest hash of its position from the corner is kept; of
// coinciding points, the first. So dense places lose points and sparse places keep them, and the kept points are as
// they were measured. The result depends only on the set of points, not on their order, on blocks or on memory. It
// needs 80 bytes times `most` of memory, and half as much again while cubes are merged.
class Thinning {
 public:
  // No coordinate of a point may be smaller than that of the corner. most >= 1.
  Thinning(Index3 corner, std::size_t most);

  void add(Index3 position, StorePlace place);

  // Returns the points that were kept so far, by place, and leaves the thinning empty.
  std::vector<KeptPoint> take();

  std::int64_t edge() const { return std::int64_t{1} << level_; }  // of a cube, lattice units

 private:
  struct Slot {
    Index3 offset;  // from the corner
    std::uint64_t rank = 0;
    StorePlace place = kNowhere;
  };
  static constexpr StorePlace kNowhere{0xffffffffu, 0xffffffffu};

  void put(const Slot& point);
  void coarsen();
  bool same_cube(Index3 a, Index3 b) const;
  std::size_t first_slot(Index3 offset) const;

  Index3 corner_;
  std::size_t most_, used_ = 0;
  int level_ = 0;
  std::vector<Slot> slots_;  // open addressing, at least half of them empty
};

}  // namespace ilot
