// SPDX-License-Identifier: Apache-2.0
// The texts on the plan of a facade: numbers of elements, levels and chains of dimensions.
#pragma once
#include <span>

#include "engine/deliverables/drawings/facade_plan.h"

namespace ilot {

// Writes the numbers of elements inside them and, where they fit, their sizes. Capitals are 2.5 mm high on paper, else
// 1.8 mm. A text that would cover a line or another text is left out: the table of elements has all of them. O(n^2)
// boxes.
void add_numbers(const Facade& facade, std::span<const FlatElement> flat, Drawing& drawing);

// Writes the heights of tops and bottoms of openings, bands, balconies and the outline, to the right of the plan.
// Heights within half a millimetre on paper are written once. Texts that would overlap are moved apart and joined to
// their height by a leader line.
void add_levels(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan, Drawing& drawing);

// Draws dimension chains over the openings: of the lowest row below the plan, of the fullest row above it (if that is
// another row), and of the fullest column left of it, with the overall sizes. Two openings belong to one row or column
// when they share at least half of the extent of the smaller one.
void add_dimensions(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan, Drawing& drawing);

}  // namespace ilot
