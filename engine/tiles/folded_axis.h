// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// The tiles along one axis, renumbered from 0 so that long stretches without tiles are left out. A second site 50 km
// away, or a point at the origin, then costs a few numbers and not all those between. The order stays, and so do all
// distances up to the widest gap that is kept.
class FoldedAxis {
 public:
  FoldedAxis() = default;
  // `tiles` are numbers on the lattice in ascending order, each once or more. Gaps of more than widest_gap tiles are
  // shortened to widest_gap.
  FoldedAxis(std::span<const std::int64_t> tiles, std::int64_t widest_gap);

  std::int64_t size() const { return size_; }  // number of tiles from the first to the last, gaps included
  bool is_folded() const { return pieces_.size() > 1; }

  // Returns the folded number of a tile of the lattice. It is -1 for a tile that is left out, before the first tile or
  // after the last. O(log gaps).
  std::int64_t folded(std::int64_t lattice_tile) const;
  // Returns the lattice number of a folded tile. Tiles before the first and after the last are numbered on. O(log
  // gaps).
  std::int64_t lattice(std::int64_t folded_tile) const;

 private:
  struct Piece {
    std::int64_t folded = 0, lattice = 0;  // of its first tile
  };
  std::vector<Piece> pieces_;
  std::int64_t size_ = 0;
};

}  // namespace ilot
