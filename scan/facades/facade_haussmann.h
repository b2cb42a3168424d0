// SPDX-License-Identifier: Apache-2.0
// The scene `facade-haussmann`: a Paris facade of the 1860s in banded stone. It has round arches, balconies with
// balusters, pediments, a cornice and a mansard roof with dormers. It is scanned from across the street (methods.md,
// cloud 1).
#pragma once
#include <cstdint>
#include <span>

#include "scan/scanners/terrestrial.h"

namespace ilot::scan {

// Values of true_class. joint: grooves between the bands. surround: borders, keystones, pediments and lintels. balcony:
// slabs, consoles, balusters and railings. moulding: bands, cornice, quoins. roof: the inclined parts. other: frames,
// panes, doors, rooms behind panes.
enum class HaussmannClass : std::uint8_t {
  mixed = kMixedClass,
  facade = 1,
  joint = 2,
  reveal = 3,
  sill = 4,
  surround = 5,
  balcony = 6,
  moulding = 7,
  roof = 8,
  other = 9
};

std::span<const SceneOption> facade_haussmann_options();
TerrestrialScan plan_facade_haussmann(const SceneValues& values, std::uint64_t seed);

}  // namespace ilot::scan
