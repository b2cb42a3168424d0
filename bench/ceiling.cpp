// SPDX-License-Identifier: Apache-2.0
// What this machine can do at best, measured now: memory bandwidth (triad over arrays far larger than the caches) and
// a loop of multiplications and additions that never leaves the registers. Other benchmarks are judged against these.
// Usage: ceiling THREADS. Prints one JSON object: best of five.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "kernels/core/parallel.h"

namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double best_of_five(const std::function<void()>& work) {
  double best = seconds(work);
  for (int i = 1; i < 5; ++i) best = std::min(best, seconds(work));
  return best;
}

// 24 bytes of traffic an element.
double triad_gigabytes_per_second(int threads) {
  const std::size_t n = std::size_t{1} << 24;
  std::vector<double> a(n, 1), b(n, 2), c(n, 3);
  const std::size_t parts = static_cast<std::size_t>(threads), part = n / parts;
  const double t = best_of_five([&] {
    ilot::parallel_for(parts, [&](std::size_t p) {
      for (std::size_t i = p * part; i < (p + 1) * part; ++i) a[i] = b[i] + 0.5 * c[i];
    });
  });
  return 24.0 * static_cast<double>(parts * part) / t / 1e9;
}

// Eight independent chains of eight lanes, so that neither latency nor memory binds.
double loop_gigaflops(int threads) {
  constexpr int kRounds = 1 << 22, kChains = 8, kLanes = 8;
  std::vector<float> sink(static_cast<std::size_t>(threads));
  const double t = best_of_five([&] {
    ilot::parallel_for(sink.size(), [&](std::size_t p) {
      float v[kChains][kLanes];
      for (auto& chain : v)
        for (float& x : chain) x = 1.0f + static_cast<float>(p);
      for (int r = 0; r < kRounds; ++r)
        for (auto& chain : v)
          for (float& x : chain) x = x * 0.999f + 0.001f;
      for (auto& chain : v)
        for (float x : chain) sink[p] += x;
    });
  });
  return 2.0 * kRounds * kChains * kLanes * threads / t / 1e9;
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1;
  ilot::with_threads(threads, [&] {
    const double triad = triad_gigabytes_per_second(threads);
    const double loop = loop_gigaflops(threads);
    std::printf("{\"threads\": %d, \"triad_gb_per_s\": %.2f, \"loop_gflop_per_s\": %.2f}\n", threads, triad, loop);
  });
}
