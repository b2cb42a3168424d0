// SPDX-License-Identifier: Apache-2.0
// The scene `building`: a free-standing house that six stations around it see. Its four facades have windows, sills and
// lintels, and its render has irregular bulges (methods.md, cloud of the Lorraine thesis).
#pragma once
#include <cstdint>
#include <span>

#include "scan/scanners/terrestrial.h"

namespace ilot::scan {

// Values of true_class. The class `other` contains frames, panes, doors, eaves, chimneys and rooms behind panes.
enum class BuildingClass : std::uint8_t {
  mixed = kMixedClass,
  facade = 1,
  sill = 2,
  lintel = 3,
  reveal = 4,
  bulge = 5,
  roof = 6,
  ground = 7,
  other = 8
};

std::span<const SceneOption> building_options();
TerrestrialScan plan_building(const SceneValues& values, std::uint64_t seed);

}  // namespace ilot::scan
