// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>

#include "kernels/core/parallel.h"

namespace ilot {

// Calls body(i) for each i in [0, count), at most `concurrency` calls at a time. This limits the memory that the calls
// need at once, whatever the number of threads.
inline void parallel_for_limited(std::size_t concurrency, std::size_t count,
                                 const std::function<void(std::size_t)>& body) {
  concurrency = std::clamp<std::size_t>(concurrency, 1, std::max<std::size_t>(count, 1));
  parallel_for(concurrency, [&](std::size_t worker) {
    for (std::size_t i = worker; i < count; i += concurrency) body(i);
  });
}

}  // namespace ilot
