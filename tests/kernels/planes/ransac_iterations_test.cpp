// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/ransac_iterations.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ilot {
namespace {

TEST(RansacIterations, KnownValues) {
  EXPECT_EQ(ransac_iterations(0.5, 3, 0.99), 35u);  // ln 0.01 / ln 0.875 = 34.49
  EXPECT_EQ(ransac_iterations(0.5, 2, 0.99), 17u);  // 16.01
  EXPECT_EQ(ransac_iterations(0.0, 3, 0.99), 1u);
  EXPECT_EQ(ransac_iterations(1.0, 3, 0.99), kMaxDraws);
  EXPECT_EQ(draws_for_probability(1e-30, 0.5), kMaxDraws);
}

TEST(RansacIterations, EqualsTheFormulaInTheMathsLibrary) {
  for (double outliers = 0.05; outliers < 0.99; outliers += 0.03)
    for (const int s : {2, 3, 6})
      for (const double p : {0.5, 0.9, 0.99, 0.9999}) {
        const double exact = std::log(1 - p) / std::log1p(-std::pow(1 - outliers, s));
        if (std::abs(exact - std::nearbyint(exact)) < 1e-9 * exact) continue;  // where rounding decides
        EXPECT_EQ(ransac_iterations(outliers, s, p), static_cast<std::uint64_t>(std::ceil(exact)))
            << outliers << " " << s << " " << p;
      }
  // Small chances keep their digits: relative error 1e-12 of the count.
  for (const double q : {1e-4, 1e-8, 1e-12}) {
    const double exact = std::log(0.01) / std::log1p(-q);
    EXPECT_NEAR(static_cast<double>(draws_for_probability(q, 0.99)), exact, 1 + 1e-12 * exact);
  }
}

TEST(RansacIterations, SafetyFactorOfDocumentA) {
  EXPECT_EQ(with_safety_factor(3), 6u);
  EXPECT_EQ(with_safety_factor(1), 1u);
  EXPECT_EQ(with_safety_factor(11), 11u);
  for (std::uint64_t n = 2; n <= 10; ++n) {
    const double v = static_cast<double>(n);
    EXPECT_EQ(with_safety_factor(n), static_cast<std::uint64_t>(std::ceil(v * (1 + std::log(v)) / std::log(v))));
  }
}

TEST(RansacIterations, ColourGuidesOnlyWhileItsShareIsLarger) {
  // A tenth of all points, half of those of its colour: 4,603 draws become 35.
  const SamplingPlan guided = plan_sampling({100, 1000, 50, 100}, 0.99);
  EXPECT_EQ(guided.from, SamplingPlan::From::kClass);
  EXPECT_EQ(guided.draws, 35u);
  EXPECT_EQ(plan_sampling({100, 1000, 5, 100}, 0.99).from, SamplingPlan::From::kAll);
  EXPECT_EQ(plan_sampling({100, 1000, 10, 100}, 0.99).from, SamplingPlan::From::kAll);  // equal: no gain
  EXPECT_EQ(plan_sampling({100, 1000, 10, 100}, 0.99).draws, 4603u);
  EXPECT_EQ(plan_sampling({}, 0.99).draws, kMaxDraws);
}

}  // namespace
}  // namespace ilot
