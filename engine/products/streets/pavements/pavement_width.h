// SPDX-License-Identifier: Apache-2.0
// The width of a pavement in a strip across it.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "ilot/streets.h"

namespace ilot {

enum class PavementPixel : std::uint8_t {
  unseen,
  ground,
  loose,   // lower than 2.2 m is what no pavement ends at: a vehicle, a person, leaves
  object,  // something else stands there, lower than 2.2 m
  fence,   // a part of a fence or a free-standing wall
  wall     // a part of a building
};

// Pixels across a pavement, row by row. A row leads away from the road and begins at the kerb.
struct PavementStrip {
  double step = 0.05;  // metres, between rows and along them
  std::uint32_t rows = 0, columns = 0;
  std::uint32_t first = 0, last = 0;  // the rows whose width is measured; those around them tell rows of objects
  std::vector<PavementPixel> pixels;
  std::vector<double> heights;  // metres, of the ground; read where a pixel is of the ground

  std::size_t at(std::uint32_t row, std::uint32_t column) const { return std::size_t{row} * columns + column; }
};

struct PavementWidthParams {
  double next_kerb = std::numeric_limits<double>::infinity();  // metres from the kerb to the next one
  double nearest_fence = 1;     // metres from the kerb; nearer ones are railings of the kerb, which are objects
  double least_barrier = 3;     // metres along the kerb; shorter rows of objects can be walked around
  double barrier_depth = 0.8;   // metres across, within which such a row stands
  double least_step = 0.1;      // metres; a lower step ends a pavement only where it is a kerb
  double longest_unseen = 1.5;  // metres without anything seen, behind which ground is another's
};

struct StripWidth {
  PavementEnd end = PavementEnd::open;
  double width = 0, passable = 0, passable_from = 0;  // metres
  double unseen_share = 0;
};

// Measures where the pavement ends that begins at the kerb. The end is where half of the rows have met a wall or a
// fence, where objects stand in a row without a gap (as hedges, and fences that were not known as such), or at a step
// of the ground, whichever is first; else the pavement is open. The passable part is the widest run of columns in which
// no row has an object. What stands in a pixel is in its middle, as good a guess as any. O(pixels).
StripWidth pavement_width(const PavementStrip& strip, const PavementWidthParams& params = {});

}  // namespace ilot
