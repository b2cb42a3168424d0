// SPDX-License-Identifier: Apache-2.0
#include "training/f_distribution.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

namespace ilot {
namespace {

// Closed forms: d1 = 2 gives (1 + 2 f / d2)^(-d2 / 2), d1 = d2 = 1 the two arms of a Cauchy distribution.
TEST(FDistribution, ClosedForms) {
  for (const std::uint32_t d2 : {1u, 2u, 7u, 100u, 438u})
    for (const double f : {0.001, 0.5, 1.0, 3.0, 40.0}) {
      const double want = std::pow(1 + 2 * f / d2, -0.5 * d2);
      EXPECT_NEAR(f_upper_tail(f, 2, d2) / want, 1, 1e-11) << f << " " << d2;
    }
  EXPECT_NEAR(f_upper_tail(1, 1, 1), 0.5, 1e-14);
  EXPECT_NEAR(f_upper_tail(3, 1, 1), 1 - 2 / M_PI * std::atan(std::sqrt(3.0)), 1e-14);
}

// Oracle: Boost.
TEST(FDistribution, EqualsBoosts) {
  for (const std::uint32_t d1 : {1u, 2u, 3u, 10u, 57u})
    for (const std::uint32_t d2 : {1u, 5u, 30u, 437u, 4001u})
      for (const double f : {1e-6, 0.03, 0.7, 1.0, 1.9, 3.8, 12.0, 150.0}) {
        const double want = boost::math::cdf(complement(boost::math::fisher_f(d1, d2), f));
        if (want < 1e-290) continue;
        EXPECT_NEAR(f_upper_tail(f, d1, d2) / want, 1, 1e-10) << f << " " << d1 << " " << d2;
      }
}

TEST(FDistribution, Ends) {
  EXPECT_EQ(f_upper_tail(0, 3, 4), 1);
  EXPECT_EQ(f_upper_tail(-2, 3, 4), 1);
  EXPECT_LT(f_upper_tail(1e30, 3, 400), 1e-300);
}

}  // namespace
}  // namespace ilot
