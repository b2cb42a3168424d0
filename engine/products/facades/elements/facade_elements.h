// SPDX-License-Identifier: Apache-2.0
// Turns what was found on a facade into elements of its plan, in the CRS.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/facade.h"
#include "engine/products/facades/elements/irregularities.h"
#include "engine/products/facades/elements/regular_facade.h"
#include "engine/products/facades/walls/wall_outline.h"

namespace ilot {

// Gives the element of an opening, or of a part that stands out of the wall or lies behind it. Its ring has one edge
// for each side; an arc has one edge for each chord of at most 5 degrees. The element has its sizes and their errors,
// and a body where its end is known.
FacadeElement element_of(const FacadeSite& site, const ElementCandidate& candidate);

// Gives the wall itself within its outline.
FacadeElement wall_of(const RaySamples& samples, const WallOutline& outline);

// Gives a part of the wall without points. A rectangle is a possible opening. Its reason says that no ray reached it
// only where a station is known.
FacadeElement unseen_of(const FacadeSite& site, const UnseenArea& area);

// Whether an element is a part of the wall of which nobody knows what is there: not seen, or a possible opening.
inline bool is_unseen_place(const FacadeElement& e) {
  return e.kind == "possible opening" || e.kind == "not seen";
}

// The part of the wall that an opening of which too little was seen is drawn as.
UnseenArea possible_area(const ElementCandidate& opening);

// Gives a bulge or a hollow: its outline in the wall and its surface as a mesh [Lorraine thesis, 4.2.2].
FacadeElement irregularity_of(const FacadeSite& site, const Irregularity& irregularity);

// The number of sides of an element that are drawn although they were not seen. An opening has four, whatever its form.
std::uint64_t unseen_sides(const FacadeElement& element);

// Removes the elements that are marked. A family of which one member is left is none, and the elements are numbered
// anew. O(n log n).
void remove_elements(const std::vector<bool>& removed, std::vector<FacadeElement>& elements);

// States the errors of width and height of an element with four sides: the root of the sum of the squares of the stated
// errors of the two sides that a size lies between, which are independent of each other. Of a head that has several
// edges the largest error counts. To be called after each change of errors of edges; others keep what they have.
void state_size_errors(FacadeElement& element);

// Adds to the errors of edges what the place of their stations is uncertain by (registration_error), as the root of the
// sum of both squares. Sizes get it once for each of their two sides, which different stations may have seen.
void add_registration(double error, std::span<FacadeElement> elements);

}  // namespace ilot
