// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <vector>

#include "engine/products/planes/cells/planes_pass.h"

namespace ilot {

// The cell of each point of a block. Cells are contiguous in a block.
struct BlockCells {
  struct Range {
    std::uint32_t first = 0, count = 0;  // points of the block
    std::uint32_t cell = 0;
  };
  std::vector<Range> ranges;             // ascending, covering the block
  std::int64_t widest_connectivity = 1;  // largest connectivity of its cells, units
};

inline std::vector<BlockCells> cells_of_blocks(const Store& store, const std::vector<Cell>& cells,
                                               const CellPlanes& planes) {
  std::vector<BlockCells> result(store.blocks().size());
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    for (const CellSlice& s : cells[c].slices) {
      BlockCells& b = result[s.block];
      b.ranges.push_back({s.first, s.count, c});
      b.widest_connectivity = std::max(b.widest_connectivity, planes.cells[c].connectivity);
    }
  }
  return result;
}

// The number of points in a view of the block with its surroundings within the connectivity.
inline std::uint64_t points_around(const Store& store, std::uint32_t block, const BlockCells& cells) {
  const Block& b = store.blocks()[block];
  return plan_view(store, b.box.grown(cells.widest_connectivity), b.node.min_corner()).size;
}

}  // namespace ilot
