// SPDX-License-Identifier: Apache-2.0
// Rows, columns and families: what was built alike is drawn alike, as far as what was measured allows [Marchand 2018,
// II.3.2].
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

enum class ElementKind : std::uint8_t {
  window,
  door,
  sill,
  lintel,
  balcony,
  band,
  bulge,
  stone,
  bracket,
  protrusion,  // bays, oriels
  recess,      // niches, cut corners
  eaves,       // what stands out above the wall's top
};

struct ElementCandidate {
  FoundRectangle shape;
  ElementKind kind = ElementKind::window;
  std::uint32_t family = 0, row = 0, column = 0;  // as FacadeElement
  std::string reason;                             // of what was not seen
};

struct RegularParams {
  double alike = 0.04;    // metres; sizes of one family and edges of one row or column differ by at most this
  double line_up = 0.25;  // metres; middles of one column
};

// Numbers families (of equal width and height, two members or more), rows by their tops and columns by their middles.
void group_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params = {});

// Moves edges onto the line of their row or column and sizes to those of their family: to the value that most of the
// members' bounds hold (agreement), never farther than an edge's own error. `moved` of the edges says how far. The
// order of the things does not matter.
void regularise_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params = {});

// Edges that nothing was seen of: the bottom of an opening behind a sill is the sill's top; other edges come from the
// row or the family, or stay occluded. `reason` says which. Completed edges keep within the gap that hid them.
void complete_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params = {});

}  // namespace ilot
