// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/rasters/image.h"

namespace ilot {

// Heights in two bytes each. A code is the height above `base`, from 0 to 65533. 65535 stands for kNoHeight and 65534
// for kAboveAll. The spans have equal size. The codes are the same on every instruction set. O(n).

// Returns false where some height has no code. The codes are then meaningless.
bool narrow_heights(std::span<const Height> heights, Height base, std::span<std::uint16_t> codes);

void widen_codes(std::span<const std::uint16_t> codes, Height base, std::span<Height> heights);

}  // namespace ilot
