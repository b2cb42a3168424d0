// SPDX-License-Identifier: Apache-2.0
// Panes that only bars part become one window.
#pragma once
#include <cstddef>
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// Joins panes of one window: first two that lie side by side or one above the other, with no more than a bar between
// them and of equal extent along the bar; then several that fill a rectangle together, as two casements below a transom
// light. Each side of the window is the side of the pane that lies farthest out, with its own error, or the better
// known one of two that end alike. A pane with an arch or a point is joined with the rectangle below it and gives the
// head; panes that lean stay alone. `cell` is the size of the cells in which they were found, in metres: where a pier
// may look like a bar, panes beside each other are joined only if their errors leave no room for a pier; the wall
// between two storeys is higher than a bar. O(n^3) in the openings of a wall at worst.
//
// The openings from `proven` on are holes that are panes only together with one of the others; those that are not
// joined with one are dropped.
void join_panes(double cell, std::size_t proven, std::vector<FoundRectangle>& found);

// Joins panes that end apart, as where a curtain hangs behind one of two casements or a transom light was not found:
// together they have the width and the foot, or the head, of an opening of their row, or the sides and the height of
// one of their column (`alike` metres for what a builder means to be equal, and their errors). Their other end may lie
// within that of their row, up to half of its height; then it is `occluded`, and its gap reaches to the end of the
// others. They stay apart where more of the others are like one of them alone. To be called after join_panes. O(n^3) at
// worst.
void join_panes_like_others(double alike, std::vector<FoundRectangle>& found);

}  // namespace ilot
