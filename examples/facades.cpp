// SPDX-License-Identifier: Apache-2.0
// The facades of a run and what is on them.
// Usage: facades RUN_FOLDER
#include <ilot/error.h>
#include <ilot/facades.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  const std::vector<ilot::Facade> facades = ilot::read_facades(argv[1]);
  for (const ilot::Facade& facade : facades) {
    std::printf("facade %u: %.2f m wide, %.2f m high\n", facade.id, facade.width_m, facade.height_m);
    for (const ilot::FacadeElement& e : facade.elements)
      std::printf("  %s %u: %.3f x %.3f m, within %.3f m\n", e.kind.c_str(), e.id, e.width_m, e.height_m,
                  e.width_error_m);
  }
  return facades.empty() ? 1 : 0;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
