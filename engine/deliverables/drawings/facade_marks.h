// SPDX-License-Identifier: Apache-2.0
// Marks around the plan of a facade: the line of the ground, and where sections are cut.
#pragma once
#include <optional>
#include <span>

#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/deliverables/drawings/named_sections.h"

namespace ilot {

// Draws the foot of the wall as the line of the ground, a little beyond both ends of it: the lowest edges of outlines
// that are level and were seen. A foot that nobody saw has no line.
void add_ground(const Facade& facade, std::span<const FlatElement> flat, Drawing& drawing);

// Draws on both sides of the plan where a section is cut, with an arrow in the direction in which it is seen and its
// name. A section along the wall has no mark.
void add_section_marks(const Facade& facade, std::span<const NamedSection> sections, const FlatBox& plan,
                       double metres_per_unit, Drawing& drawing);

// Returns where grid north is on a drawing whose x axis has this direction in plan and which is seen from below, in
// degrees from x towards y.
double north_of(double right_x, double right_y);

}  // namespace ilot
