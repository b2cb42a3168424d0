// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/quantile.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(Quantile, EvenNumberOfValues) {
  const std::vector<int> values{40, 10, 30, 20};
  EXPECT_EQ(lower_quantile(std::vector(values), 0), 10);
  EXPECT_EQ(lower_quantile(std::vector(values), 0.5), 20);
  EXPECT_EQ(lower_quantile(std::vector(values), 0.99), 30);
  EXPECT_EQ(lower_quantile(std::vector(values), 1), 40);
  EXPECT_EQ(upper_median(std::vector(values)), 30);
  EXPECT_EQ(upper_median(std::vector{7}), 7);
}

TEST(Quantile, RanksAreThoseOfSortedValues) {
  Rng rng(3);
  for (std::size_t n = 1; n < 60; ++n) {
    std::vector<double> values(n);
    for (double& v : values) v = static_cast<double>(rng.below(20));
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t rank = 0; rank < n; ++rank) EXPECT_EQ(nth_smallest(values, rank), sorted[rank]);
    EXPECT_EQ(upper_median(values), sorted[n / 2]);
    for (std::size_t eighth = 0; eighth <= 8; ++eighth)
      EXPECT_EQ(lower_quantile(values, static_cast<double>(eighth) / 8), sorted[eighth * (n - 1) / 8]);
  }
}

}  // namespace
}  // namespace ilot
