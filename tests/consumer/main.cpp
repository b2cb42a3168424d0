// SPDX-License-Identifier: Apache-2.0
// A program of somebody else's: uses the installed headers and both libraries.
#include <atomic>
#include <cstdio>

#include "engine/error.h"
#include "engine/settings/config.h"
#include "engine/version.h"
#include "kernels/core/parallel.h"

int main() {
  std::atomic<int> sum{0};
  ilot::with_threads(2, [&] { ilot::parallel_for(100, [&](std::size_t i) { sum += static_cast<int>(i); }); });
  ilot::Settings settings;
  ilot::apply_assignment(settings, "planes.epsilon=0.02");
  bool refused = false;
  try {
    ilot::apply_assignment(settings, "planes.epsilon=-1");
  } catch (const ilot::Error& fault) {
    refused = fault.code() == ilot::ExitCode::usage;
  }
  std::printf("ilot %s: sum %d, epsilon %g\n", ilot::version().c_str(), sum.load(), *settings.planes.epsilon);
  return sum == 4950 && refused && *settings.planes.epsilon == 0.02 ? 0 : 1;
}
