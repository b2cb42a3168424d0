// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot::scan {

// Returns continuous noise within [-1, 1): there is a random value at each corner of a lattice with side 1, with smooth
// interpolation between corners. (Perlin 1985, values in place of gradients)
double value_noise(Vec3 p, std::uint64_t key);

}  // namespace ilot::scan
