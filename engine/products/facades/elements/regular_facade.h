// SPDX-License-Identifier: Apache-2.0
// Rows, columns and families: elements that were built alike are drawn alike, as far as the measurements allow
// [Marchand 2018, II.3.2].
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
  shutter,     // leaves before the wall
  protrusion,  // bays, oriels
  recess,      // niches, cut corners
  eaves,       // stands out above the top of the wall
};

struct ElementCandidate {
  FoundRectangle shape;
  ElementKind kind = ElementKind::window;
  std::uint32_t family = 0, row = 0, column = 0;  // as in FacadeElement
  std::string reason;                             // why an edge that was not seen has its place
  bool possible = false;                          // an opening of which so little was seen that it has no size
};

struct RegularParams {
  double alike = 0.04;    // metres; sizes of one family and edges of one row or column differ by at most this
  double line_up = 0.25;  // metres between the middles of one column, at most
};

// Numbers the families (at least two members of equal width and height), the rows by their tops and the columns by
// their middles.
void group_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params = {});

// Moves edges onto the line of their row or column, and changes sizes to that of their family, where the measurements
// prove that they are equal: the scatter of all rows together (or columns, widths, heights), or of one of them alone,
// is so small that by a chi-square test of 90 % confidence the true values differ by less than what their measurements
// are wrong by. `alike` only says which edges are compared. The new value is the one that lies within the bounds of
// most members (agreement). No edge moves farther than its own error, in all its moves together, and its error does not
// change; its field `moved` records the distance. The order of the candidates does not change the result.
void regularise_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params = {});

// Completes edges that were not seen. The bottom of an opening behind a sill is the top of the sill. Other edges come
// from the row or the family, or stay occluded. The field `reason` says which. Completed edges stay within the gap that
// hid them, and their error reaches to both ends of it. None is below the foot of the wall.
//
// Edges that stay occluded are where the opening was last seen, if at least half of what it may be at most was seen to
// be open. Otherwise they are in the middle of their gaps. If even so half would not be sure - the opening that is
// drawn has less than half in common with the least or with the most that it may be - it is only a `possible` one.
// Where sides of one direction are hidden, that is so if less than a third was seen. Nothing is decided by a gap of
// which no far end is known.
void complete_elements(std::vector<ElementCandidate>& candidates, const RegularParams& params = {});

}  // namespace ilot
