// SPDX-License-Identifier: Apache-2.0
// What stands on the streets of a run.
// Usage: streets RUN_FOLDER
#include <ilot/error.h>
#include <ilot/streets.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  const ilot::StreetPlan plan = ilot::read_streets(argv[1]);
  for (const ilot::StreetObject& o : plan.objects)
    std::printf("object %u%s: %.2f x %.2f m, %.2f m high, at %.2f %.2f\n", o.id,
                o.label == ilot::PointLabel::car ? " (car)" : "", o.length_m, o.width_m, o.height_m, o.base.x,
                o.base.y);
  std::printf("%zu blocks, %zu gaps\n", plan.blocks.size(), plan.gaps.size());
  return plan.objects.empty() ? 1 : 0;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
