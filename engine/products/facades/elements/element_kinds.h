// SPDX-License-Identifier: Apache-2.0
// Gives each facade element its kind, from its shape and from what is beside it.
#pragma once
#include <vector>

#include "engine/products/facades/elements/regular_facade.h"

namespace ilot {

// Choice: sills between deep reveals are shorter than the opening; a sill broken by a pipe becomes a bulge.
constexpr double kUnder = 0.7;  // share of the width of the opening that a sill or a lintel covers

// Sizes that decide the kinds, in metres.
struct ElementKindParams {
  double door_height = 1.8;     // of a door, at least
  double door_sill = 0.4;       // bottom of a door above the foot of the wall, at most
  double balcony_depth = 0.3;   // how far a balcony stands out, at least
  double balcony_width = 0.5;   // nobody stands on a narrower element, it carries another one
  double balcony_height = 1.5;  // of a balcony with its parapet, at most
};

inline bool is_opening(ElementKind kind) {
  return kind == ElementKind::window || kind == ElementKind::door;
}

// A door reaches the foot of the wall. Where its lower part is hidden, its top is in line with the tops of other doors.
ElementKind kind_of_opening(const FoundRectangle& r, const std::vector<FoundRectangle>& openings,
                            const ElementKindParams& params = {});

// A long element across the wall is a band or a balcony. An element just below an opening is its sill, one just above
// it is its lintel. An element that stands out far is a balcony. It is a bracket if it is too narrow to stand on, and a
// protrusion if it is as high as a storey.
ElementKind kind_of_relief(const FoundRectangle& r, const std::vector<FoundRectangle>& openings, double wall_width,
                           const ElementKindParams& params = {});

// Where one opening has two sills or two lintels, the nearest one keeps its kind. The other becomes a bulge: a panel
// below, a hood above. O(candidates^2).
void keep_nearest_sills(std::vector<ElementCandidate>& candidates);

// Drops the openings of which most lies in a larger one that stays, or in an earlier one of the same size that stays:
// rays went through the wall at one place. An opening that is only possible gives way to any other. The order of what
// stays does not change. O(n^2) in the openings.
void drop_openings_within(std::vector<ElementCandidate>& candidates);

// What stands out above the wall is eaves. A balcony is long, lower than a storey, and deep enough to stand on.
ElementKind kind_of_large(const FoundRectangle& r, double wall_height, const ElementKindParams& params = {});

// Whether the candidate is a rail or a bar in front of windows or along a balcony.
bool is_rail(const ElementCandidate& t);

}  // namespace ilot
