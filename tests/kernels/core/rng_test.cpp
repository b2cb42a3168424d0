// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ilot {
namespace {

TEST(Rng, IsAFunctionOfKeyAndCounterAlone) {
  Rng sequential(7);
  const Rng indexed(7);
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_EQ(sequential.next(), indexed.at(i));
  EXPECT_NE(Rng(7).at(0), Rng(8).at(0));
  EXPECT_NE(Rng(7, 1).at(0), Rng(7, 2).at(0));
}

TEST(Rng, BelowIsUniform) {
  Rng rng(1);
  std::vector<int> histogram(10);
  const int draws = 100000;
  for (int i = 0; i < draws; ++i) ++histogram[rng.below(10)];
  // 5 standard deviations of a binomial count.
  const double bound = 5 * std::sqrt(draws * 0.1 * 0.9);
  for (int count : histogram) EXPECT_NEAR(count, draws / 10, bound);
}

TEST(Rng, UniformLiesInHalfOpenUnitInterval) {
  Rng rng(2);
  double sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const double u = rng.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100000, 0.5, 5 * 0.2887 / std::sqrt(100000.0));
}

}  // namespace
}  // namespace ilot
