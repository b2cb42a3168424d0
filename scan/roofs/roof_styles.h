// SPDX-License-Identifier: Apache-2.0
// Draws roofs at random: a gable, a hip, or one of many complex kinds (cross wings, dormers, mansards, split levels,
// annexes).
#pragma once
#include <vector>

#include "kernels/core/rng.h"
#include "scan/roofs/roof_partition.h"

namespace ilot::scan {

enum class RoofKind : std::uint8_t { gable, hip, complex };
const char* name_of(RoofKind kind);

enum class BuiltForm : std::uint8_t { detached, terraced };  // terraced: a rectangle with blind walls to either side

struct RoofDesign {
  RoofKind kind = RoofKind::gable;
  std::vector<Wing> wings;  // heights above the foot of the building
};

// No part of a roof is higher than this above the foot of its building.
constexpr Integer kMaxRoofHeight = 17000;  // millimetres

// Draws a roof. `chimneys` is the share of the houses that have one. Not every drawn roof is a sound solid: see
// fault_of.
RoofDesign draw_roof(Rng& rng, RoofKind kind, BuiltForm built_form, double chimneys);

// Returns the box around all wings.
GridRect bounds_of(const std::vector<Wing>& wings);

}  // namespace ilot::scan
