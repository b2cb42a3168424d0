// SPDX-License-Identifier: Apache-2.0
// Takes planes up beyond the borders of the cells in which they were found, so that planes end where the surface ends.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/planes/join/join_pass.h"

namespace ilot {

// Number of rounds. In a round a plane can pass from a cell to the cells that touch it, so a plane reaches at most this
// number of cells beyond those in which it was found. On five real clouds, a fifth round would change one point in
// 2,000 at most; after three, planes that came around an obstacle still ended at borders.
constexpr int kExtendRounds = 4;

// The cells beyond an area on which the planes inside it depend: the rounds, the cell itself and the margin from which
// it was searched.
constexpr int kCellsAround = kExtendRounds + 2;

// Writes the columns "extended_1" to "extended_4": the points whose joined plane is another than that of their cell,
// before it is measured again. In each round, every cell is worked on with its surroundings within the connectivity, by
// extend_planes (kernels/planes/extend.h). The result of a cell depends on the labels before the round alone, so the
// order of the cells does not matter. Planes with more points come first, in ties the earlier one. Sets too_small for
// planes that have lost too many points; their points count as points without a plane afterwards. O(n log n).
void extend_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& found, JoinedPlanes& joined,
                 const PassContext& context);

// Reads the joined planes of consecutive points of a block after all rounds: 0 = none, else 1 + index.
void read_extended(const Store& store, const JoinedPlanes& joined, std::uint32_t block, std::uint32_t first,
                   std::span<std::uint32_t> planes);

}  // namespace ilot
