// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/where.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(Where, AllThatMatchInOrder) {
  Rng rng(4, 1);
  for (const std::size_t size : {0, 1, 15, 16, 17, 32, 100})
    for (const std::uint32_t one_in : {1u, 2u, 20u, 1000u}) {
      std::vector<std::uint8_t> flags;
      std::vector<std::size_t> want, got;
      for (std::size_t i = 0; i < size; ++i) {
        flags.push_back(rng.below(one_in) == 0);
        if (flags.back() != 0) want.push_back(i);
      }
      for_each_where(
          size, [&](std::size_t i) { return static_cast<int>(flags[i]); }, [&](std::size_t i) { got.push_back(i); });
      EXPECT_EQ(got, want) << size << " " << one_in;
    }
}

}  // namespace
}  // namespace ilot
