// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "engine/products/streets/ground/cells.h"

namespace ilot {

struct TerrainParams {
  double steepest = 0.35;  // rise over run; ground that is steeper is joined to other ground by small steps
  double step = 0.3;       // metres above the envelope; kerbs and roughness of the ground
  double reach = 30;       // metres; half of the width of a house, and how far the ground continues below what hides it
  double rise = 0.12;      // metres; greatest step between cells of one surface on level ground, a kerb
  double terrace = 25;     // square metres; a raised surface that is larger and low is ground: a garden, a platform
  double terrace_height = 1.2;  // metres; greatest mean height of a terrace above the envelope, lower than any roof
  double least_raised = 15;     // square metres; smaller raised parts of a surface are objects, as cars and vans
  double highest = 3;           // metres above the envelope; a terrace, above it is no ground
  double deepest_pit = 0.5;     // metres; lone cells that are deeper below all others near them hold no ground
};

// What the search for the terrain counted.
struct TerrainCounts {
  std::uint64_t cells = 0, ground = 0;  // with a point, and of these on the ground
};

// Finds the height of the ground in each cell from the lowest points. Reads the layer "lowest" (lowest z of each cell,
// kNoHeight where it has no point) and writes "terrain".
//  - Lone cells that lie deep below their surroundings, as mirrored points do, are left out.
//  - The envelope from below is the lowest cone of slope `steepest` over all cells within `reach`. A cell is sure to be
//    ground where it is at most `step` above it [the slope-based filter of Vosselman 2000].
//  - Surfaces are flat zones of the lowest heights. A surface is ground if at least half of its cells are sure, and if
//    it does not stand above its surroundings while cells of it are unsure, as a large roof does. Large low surfaces
//    are ground too, as terraced gardens. All surfaces count: streets, yards and terraces need not be connected.
//  - Elsewhere the terrain is a mean of the nearest ground within `reach`, and beyond that the envelope.
// Every cell with a point within `reach` has a terrain.
TerrainCounts find_terrain(const Cells& cells, const TerrainParams& params = {});

}  // namespace ilot
