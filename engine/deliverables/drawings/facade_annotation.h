// SPDX-License-Identifier: Apache-2.0
// What is written on a facade's plan: numbers of elements, levels, chains of dimensions.
#pragma once
#include <span>

#include "engine/deliverables/drawings/facade_plan.h"

namespace ilot {

// Numbers and, where they fit, sizes of elements, inside of them, in capitals of 2.5 mm on paper, else 1.8. None where
// it would lie across a line or another text: the table of elements has all. O(n^2) boxes.
void add_numbers(const Facade& facade, std::span<const FlatElement> flat, Drawing& drawing);

// Heights of tops and bottoms of openings, bands, balconies and the outline, right of the plan, once each within half a
// millimetre on paper, moved apart where they would overlap and led to where they belong.
void add_levels(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan, Drawing& drawing);

// Chains over the openings: of the lowest row below the plan and of the fullest row above it (where that is another),
// of the fullest column left of it, with the overall sizes. Rows and columns are openings of which half of the smaller
// one's extent is common.
void add_dimensions(const Facade& facade, std::span<const FlatElement> flat, const FlatBox& plan, Drawing& drawing);

}  // namespace ilot
