// SPDX-License-Identifier: Apache-2.0
// The plan of one facade. The public interface defines it.
#pragma once
#include <array>
#include <cstddef>

#include "ilot/facades.h"
#include "kernels/core/types.h"

namespace ilot {

// The words for DrawnStatus in files and on pages, in its order.
constexpr std::array<const char*, 4> kDrawnStatusNames{"seen", "completed", "occluded", "by hand"};

inline const char* name_of(DrawnStatus status) {
  return kDrawnStatusNames.at(static_cast<std::size_t>(status));
}

}  // namespace ilot
