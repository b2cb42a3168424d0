// SPDX-License-Identifier: Apache-2.0
// Leaves of shutters among the plates that lie on a wall, and the windows behind those that are closed.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/facades/leaves/flat_plates.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

enum class LeafState : std::uint8_t { open, half, closed, blind };

// Leaves of one window as far as they lie in one plane: one of an open pair, or all of a closed pair.
struct ShutterLeaf {
  FoundRectangle shape;  // its depth is before the wall, or within the reveal
  LeafState state = LeafState::open;
};

// Tells leaves from other plates by the openings of the same facade, with `alike` metres for what a builder means to be
// equal:
// - an open leaf lies beside an opening, begins and ends at its height and is no wider than it;
// - a closed leaf has the heights of an opening of its row, or the size of one of its column, or that of another closed
//   leaf in its row or column. One end that something hides may differ: it is taken from the other. A plate over an
//   opening of its size is a leaf of this opening. Without such openings, three plates of one size, higher than wide
//   and in rows or columns, are closed leaves where each has wall around it.
// Pilasters reach over storeys, panels below windows are lower than these, quoins and signs have no size of an opening.
//
// Adds the windows behind closed leaves to the openings; their outline is that of the leaves, with the head of the
// opening in their row where it is an arch. Returns the leaves.
std::vector<ShutterLeaf> find_shutters(const FlatPlates& found, double alike, double cell,
                                       std::vector<FoundRectangle>& openings);

}  // namespace ilot
