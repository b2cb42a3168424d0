// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/value_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Values without a pattern, of a few places only, of one place, and far apart: against sorting.
TEST(ValueStream, TheSameAsSorting) {
  Rng rng(9);
  for (const std::size_t count : {1u, 2u, 32768u, 32769u, 300000u})
    for (const int kind : {0, 1, 2, 3}) {
      std::vector<double> values(count);
      for (double& v : values) {
        const double at = rng.uniform();
        v = kind == 0 ? at - 0.5 : kind == 1 ? std::floor(5 * at) : kind == 2 ? 7 : at < 0.999 ? 1e-9 * at : 1e9 * at;
      }
      const ValueStream stream = [&](const std::function<void(double)>& take) {
        for (const double v : values) take(v);
      };
      std::vector<double> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      for (const double share : {0.0, 0.005, 0.5, 0.995, 1.0}) {
        const auto rank = static_cast<std::size_t>(share * static_cast<double>(count - 1));
        EXPECT_EQ(nth_value(stream, count, rank), sorted[rank]) << count << " " << kind << " " << share;
      }
    }
}

// Both coordinates and both ranks at once: the same as each alone.
TEST(ValueStream, PlacesAsValues) {
  Rng rng(10);
  for (const std::size_t count : {1u, 2u, 32768u, 32769u, 200000u}) {
    std::vector<std::array<double, 2>> places(count);
    for (auto& p : places) p = {rng.uniform(), std::floor(3 * rng.uniform())};
    const PlaceStream stream = [&](const std::function<void(double, double)>& take) {
      for (const auto& p : places) take(p[0], p[1]);
    };
    const std::array<std::uint64_t, 2> ranks{(count - 1) / 200, count - 1 - (count - 1) / 200};
    const auto got = nth_places(stream, count, ranks);
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t r = 0; r < 2; ++r) {
        const ValueStream one = [&](const std::function<void(double)>& take) {
          for (const auto& p : places) take(p[axis]);
        };
        EXPECT_EQ(got[axis][r], nth_value(one, count, ranks[r])) << count << " " << axis << " " << r;
      }
  }
}

}  // namespace
}  // namespace ilot
