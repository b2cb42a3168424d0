// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "kernels/rasters/image.h"

namespace ilot {

// Heights in two bytes each: how far they lie above `base`, from 0 to 65533; 65535 for kNoHeight, 65534 for kAboveAll.
// Spans of equal size. Same codes on every instruction set. O(n).

// False where some height has no code; the codes then mean nothing.
bool narrow_heights(std::span<const Height> heights, Height base, std::span<std::uint16_t> codes);

void widen_codes(std::span<const std::uint16_t> codes, Height base, std::span<Height> heights);

}  // namespace ilot
