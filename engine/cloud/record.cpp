// SPDX-License-Identifier: Apache-2.0
#include "engine/cloud/record.h"

namespace ilot {

std::size_t standard_size(std::uint8_t point_format) {
  constexpr std::array<std::size_t, 11> kSizes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  return point_format < kSizes.size() ? kSizes[point_format] : 0;
}

}  // namespace ilot
