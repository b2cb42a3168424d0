// SPDX-License-Identifier: Apache-2.0
// What a thing on a facade is called, by its shape and by what is beside it.
#pragma once
#include <vector>

#include "engine/products/facades/elements/regular_facade.h"

namespace ilot {

inline bool is_opening(ElementKind kind) {
  return kind == ElementKind::window || kind == ElementKind::door;
}

// A door goes down to the foot of the wall; where its lower part is hidden, its top is in line with other doors'.
ElementKind kind_of_opening(const FoundRectangle& r, const std::vector<FoundRectangle>& openings);

// Long ones across the wall are bands or balconies, those just below and above an opening its sill and its lintel; what
// stands out far is a balcony, a bracket where it is too narrow to stand on, a protrusion where it is a storey high.
ElementKind kind_of_relief(const FoundRectangle& r, const std::vector<FoundRectangle>& openings, double wall_width);

// Of two sills, or two lintels, of one opening the one next to it keeps its name; the other is a bulge: a panel below,
// a hood above. O(things^2).
void keep_nearest_sills(std::vector<ElementCandidate>& candidates);

// What stands out above the wall is eaves; a balcony is long, no storey high and stands out as far as one can stand on.
ElementKind kind_of_large(const FoundRectangle& r, double wall_height);

// Rails and bars before windows and along balconies.
bool is_rail(const ElementCandidate& t);

}  // namespace ilot
