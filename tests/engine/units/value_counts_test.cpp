// SPDX-License-Identifier: Apache-2.0
#include "engine/units/value_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// `different` heights on a lattice of a tenth of a millimetre.
std::vector<double> heights(std::uint64_t seed, std::size_t count, std::uint64_t different) {
  Rng rng(seed);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(rng.below(different)) * 1e-4 - 2);
  return values;
}

double nth_of(const std::vector<double>& values, std::uint64_t n) {
  ValueCounts counts;
  for (const double v : values) counts.add(v);
  EXPECT_EQ(counts.count(), values.size());
  return counts.nth(n);
}

TEST(ValueCounts, AreThoseOfTheSortedValues) {
  for (const std::size_t count : {1, 2, 1000, 65536, 65537, 300000}) {
    std::vector<double> values = heights(count, count, 50000);
    std::vector<double> sorted(values);
    std::sort(sorted.begin(), sorted.end());
    for (const std::size_t n : {std::size_t{0}, count / 10, count / 2, count - 1})
      EXPECT_EQ(nth_of(values, n), sorted[n]) << count << " " << n;
  }
}

TEST(ValueCounts, TooManyDifferentOnesAreRoundedDown) {
  std::vector<double> values = heights(7, 400000, 2000000);  // 200 m: 204,800 multiples of 1/1024, 51,200 of 1/256
  std::vector<double> sorted(values);
  std::sort(sorted.begin(), sorted.end());
  for (const std::size_t n : {0, 40000, 200000, 399999})
    EXPECT_EQ(nth_of(values, n), std::floor(sorted[n] * 256) / 256) << n;
  std::reverse(values.begin(), values.end());
  EXPECT_EQ(nth_of(values, 280000), std::floor(sorted[280000] * 256) / 256);
}

}  // namespace
}  // namespace ilot
