// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>

#include "kernels/core/parallel.h"

namespace ilot {

// Calls body(i) for each i in [0, count), at most `lanes` at a time: what they need is needed so often at once, however
// many threads there are.
inline void in_lanes(std::size_t lanes, std::size_t count, const std::function<void(std::size_t)>& body) {
  lanes = std::clamp<std::size_t>(lanes, 1, std::max<std::size_t>(count, 1));
  parallel_for(lanes, [&](std::size_t lane) {
    for (std::size_t i = lane; i < count; i += lanes) body(i);
  });
}

}  // namespace ilot
