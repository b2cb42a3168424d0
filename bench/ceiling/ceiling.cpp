// SPDX-License-Identifier: Apache-2.0
// Measures the best performance of this machine: memory bandwidth (reading, and a triad, over arrays far larger than
// the caches) and arithmetic that stays in the registers. Kernels are compared with these values.
// Usage: ceiling [THREADS ...], 1 and 2 if none are given. It prints one line of JSON for each, the best of five.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <numeric>
#include <vector>

#include "bench/ceiling/score_loop.h"
#include "bench/compare.h"
#include "kernels/core/parallel.h"

namespace {

using namespace ilot;

double best_of_five(const std::function<void()>& work) {
  double best = 0;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const double t = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    best = i == 0 ? t : std::min(best, t);
  }
  return best;
}

struct Bandwidth {
  double read, triad;  // GB/s
};

// Reading moves 8 bytes per element, the triad 24.
Bandwidth bandwidth() {
  constexpr std::size_t kElements = std::size_t{1} << 25, kParts = 16, kPart = kElements / kParts;
  std::vector<double> a(kElements, 1), b(kElements, 2), c(kElements, 3), sums(kParts);
  const double triad = best_of_five([&] {
    parallel_for(kParts, [&](std::size_t p) {
      for (std::size_t i = p * kPart; i < (p + 1) * kPart; ++i) a[i] = b[i] + 0.5 * c[i];
    });
  });
  const double read = best_of_five([&] {
    parallel_for(kParts, [&](std::size_t p) {
      double lanes[32] = {};
      for (std::size_t i = p * kPart; i < (p + 1) * kPart; i += 32)
        for (std::size_t l = 0; l < 32; ++l) lanes[l] += a[i + l];
      sums[p] = std::accumulate(lanes, lanes + 32, 0.0);
    });
  });
  return {8e-9 * kElements / read, 24e-9 * kElements / triad};
}

}  // namespace

int main(int argc, char** argv) {
  for (const double n : bench::numbers(argc, argv, {1, 2})) {
    with_threads(static_cast<int>(n), [&] {
      const Bandwidth memory = bandwidth();
      constexpr double kWork = 4e9;
      const double seconds = best_of_five([] { bench::score_loop(kWork); });
      bench::report({.kernel = "ceiling", .variant = "", .threads = static_cast<int>(n)},
                    {{"read_gb_per_s", memory.read},
                     {"triad_gb_per_s", memory.triad},
                     {"loop_g_point_planes_per_s", kWork / seconds / 1e9}});
    });
  }
}
