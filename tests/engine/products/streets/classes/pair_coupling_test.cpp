// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/pair_coupling.h"

#include <gtest/gtest.h>

#include <numeric>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

TEST(PairCoupling, PairsThatAgreeGiveTheirClassesBack) {
  Rng rng(5);
  for (std::size_t k = 2; k < 9; ++k) {
    std::vector<double> p, first;
    for (std::size_t c = 0; c < k; ++c) p.push_back(0.05 + rng.uniform());
    const double sum = std::accumulate(p.begin(), p.end(), 0.0);
    for (std::size_t a = 0; a < k; ++a)
      for (std::size_t b = a + 1; b < k; ++b) first.push_back(p[a] / (p[a] + p[b]));
    const std::vector<double> found = coupled_pairs(first, k);
    ASSERT_EQ(found.size(), k);
    for (std::size_t c = 0; c < k; ++c) EXPECT_NEAR(found[c], p[c] / sum, 1e-12);
  }
}

// What the coupling makes small, beside all that is near.
TEST(PairCoupling, PairsThatDisagreeAreMetAsNearlyAsCanBe) {
  const std::vector<double> first{0.9, 0.3, 0.8};  // 0 before 1, 1 before 2, 2 before 0
  const auto misfit = [&](double p0, double p1, double p2) {
    const double a = 0.1 * p0 - 0.9 * p1, b = 0.7 * p0 - 0.3 * p2, c = 0.2 * p1 - 0.8 * p2;
    return a * a + b * b + c * c;
  };
  const std::vector<double> p = coupled_pairs(first, 3);
  EXPECT_NEAR(p[0] + p[1] + p[2], 1, 1e-12);
  const double least = misfit(p[0], p[1], p[2]);
  for (const double d : {-1e-3, 1e-3}) {
    EXPECT_GT(misfit(p[0] + d, p[1] - d, p[2]), least);
    EXPECT_GT(misfit(p[0] + d, p[1], p[2] - d), least);
    EXPECT_GT(misfit(p[0], p[1] + d, p[2] - d), least);
  }
}

TEST(PairCoupling, WhatIsSureStaysSure) {
  const std::vector<double> p = coupled_pairs({1, 1, 1, 0.5, 0.5, 0.5}, 4);
  EXPECT_GT(p[0], 0.999999);
  for (std::size_t c = 1; c < 4; ++c) EXPECT_NEAR(p[c], 0, 1e-6);
}

}  // namespace
}  // namespace ilot
