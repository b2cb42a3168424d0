// SPDX-License-Identifier: Apache-2.0
// The scene `facade-restoration`: a plain town house of the Restoration period. One station stands to the left of it,
// so sills and reveals throw laser shadows (methods.md 6, cloud 2).
#pragma once
#include <cstdint>
#include <span>

#include "scan/scanners/terrestrial.h"

namespace ilot::scan {

// Values of true_class. wall: returns and reveals, which are perpendicular to the facade. other: frames, panes, doors,
// ironwork, mouldings, the roof, rooms behind panes.
enum class RestorationClass : std::uint8_t { mixed = kMixedClass, facade = 1, sill = 2, wall = 3, other = 4 };

std::span<const SceneOption> facade_restoration_options();
TerrestrialScan plan_facade_restoration(const SceneValues& values, std::uint64_t seed);

}  // namespace ilot::scan
