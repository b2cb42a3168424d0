// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/measure_store.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

std::vector<Index3> scattered(std::uint64_t points, std::int64_t side) {
  Rng rng(4);
  std::vector<Index3> list;
  for (std::uint64_t i = 0; i < points; ++i)
    list.push_back({700000000 + static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(side))),
                    660000000 + static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(side))),
                    30000 + static_cast<std::int64_t>(rng.below(20))});
  return list;
}

// Points at random places of a plane have their nearest neighbour at 0.47 of the root of the area of each (median).
TEST(MeasureStore, TheStepIsThatOfThePoints) {
  const test::CloudStore cloud(scattered(40000, 100000));
  const CloudMeasure m = measure_store(cloud.store(), {});
  EXPECT_EQ(m.points, cloud.store().points());
  EXPECT_NEAR(m.sampling_step, 0.47 * 0.5, 0.02);
  EXPECT_NEAR(m.density, 4, 0.3);
  EXPECT_EQ(m.last_returns, m.points);
  EXPECT_NEAR(m.max.x - m.min.x, 100, 0.1);
  const test::CloudStore small(scattered(40000, 100000), {.block_points = 3000});
  EXPECT_GT(small.store().blocks().size(), 5u);
  EXPECT_EQ(measure_store(small.store(), {}).sampling_step, m.sampling_step);
  EXPECT_EQ(measure_store(small.store(), {}).density, m.density);
  PassContext feet;
  feet.metres_per_unit = 0.3048;
  EXPECT_NEAR(measure_store(cloud.store(), feet).sampling_step, 0.3048 * m.sampling_step, 1e-9);
}

}  // namespace
}  // namespace ilot
