// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/folded_axis.h"

#include <algorithm>

namespace ilot {

FoldedAxis::FoldedAxis(std::span<const std::int64_t> tiles, std::int64_t widest_gap) {
  std::int64_t last = 0;
  for (const std::int64_t tile : tiles) {
    if (pieces_.empty()) {
      pieces_.push_back({0, tile});
      size_ = 1;
    } else if (tile - last - 1 > widest_gap) {
      pieces_.push_back({size_ + widest_gap, tile});
      size_ += widest_gap + 1;
    } else {
      size_ += tile - last;
    }
    last = tile;
  }
}

std::int64_t FoldedAxis::folded(std::int64_t lattice_tile) const {
  auto next = std::upper_bound(pieces_.begin(), pieces_.end(), lattice_tile,
                               [](std::int64_t tile, const Piece& p) { return tile < p.lattice; });
  if (next == pieces_.begin()) return -1;
  const std::int64_t end = next == pieces_.end() ? size_ : next->folded;
  --next;
  const std::int64_t tile = lattice_tile - next->lattice + next->folded;
  return tile < end ? tile : -1;
}

std::int64_t FoldedAxis::lattice(std::int64_t folded_tile) const {
  if (pieces_.empty()) return folded_tile;
  auto piece = std::upper_bound(pieces_.begin() + 1, pieces_.end(), folded_tile,
                                [](std::int64_t tile, const Piece& p) { return tile < p.folded; });
  --piece;
  return folded_tile - piece->folded + piece->lattice;
}

}  // namespace ilot
