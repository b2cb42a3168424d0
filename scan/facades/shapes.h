// SPDX-License-Identifier: Apache-2.0
// The scene `shapes`: cylinders, spheres, cones and boxes of several sizes on a floor. They are upright or tilted, and
// some have fewer than 500 points.
#pragma once
#include <cstdint>
#include <span>

#include "scan/scanners/terrestrial.h"

namespace ilot::scan {

// Values of true_class.
enum class ShapeClass : std::uint8_t { mixed = kMixedClass, plane = 1, cylinder = 2, sphere = 3, cone = 4 };

std::span<const SceneOption> shapes_options();
TerrestrialScan plan_shapes(const SceneValues& values, std::uint64_t seed);

}  // namespace ilot::scan
