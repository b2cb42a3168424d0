// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/narrow_heights.h"

#include <cassert>

#include "kernels/rasters/rows_body.h"

namespace ilot {

bool narrow_heights(std::span<const Height> heights, Height base, std::span<std::uint16_t> codes) {
  assert(heights.size() == codes.size());
  return simd::kRasterRows.best().narrow_heights(
      {heights.data(), codes.data(), heights.size(), base, kNoHeight, kAboveAll});
}

void widen_codes(std::span<const std::uint16_t> codes, Height base, std::span<Height> heights) {
  assert(heights.size() == codes.size());
  simd::kRasterRows.best().widen_codes({codes.data(), heights.data(), codes.size(), base, kNoHeight, kAboveAll});
}

}  // namespace ilot
