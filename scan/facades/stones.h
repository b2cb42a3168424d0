// SPDX-License-Identifier: Apache-2.0
// The scene `stones`: four facing stones, the joints between them, and two walls perpendicular to them. It imitates a
// part that is cut out of the scan of a facade (methods.md 6, cloud 1bis).
#pragma once
#include <cstdint>
#include <span>

#include "scan/scanners/terrestrial.h"

namespace ilot::scan {

// Values of true_class.
enum class StonesClass : std::uint8_t { mixed = kMixedClass, stones = 1, joint = 2, side_1 = 3, side_2 = 4 };

std::span<const SceneOption> stones_options();
TerrestrialScan plan_stones(const SceneValues& values, std::uint64_t seed);

}  // namespace ilot::scan
