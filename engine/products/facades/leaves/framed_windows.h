// SPDX-License-Identifier: Apache-2.0
// Windows that stand out of the wall: their frames are plates before it.
#pragma once
#include <vector>

#include "engine/products/facades/leaves/shutters.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

// A plate before the wall, up to `most_depth` metres, is the frame of a window where the panes that were found in it
// take its whole width: the opening becomes as high as the frame, whose other panes may be dark or curtained. A plate
// without a pane, of the size of such a window or of another opening and in its row or column, hides a window of that
// size: it is added. Nearer than leaves stand out, the plate is returned as its closed leaves, else it stays relief.
// `alike`: metres for what a builder means to be equal; `cell`: metres across the cells of the wall. Frames and leaves
// are taken from the relief. O(n^2).
std::vector<ShutterLeaf> find_framed_windows(double most_depth, double alike, double cell,
                                             std::vector<FoundRectangle>& relief,
                                             std::vector<FoundRectangle>& openings);

}  // namespace ilot
