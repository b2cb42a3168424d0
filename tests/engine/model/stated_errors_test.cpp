// SPDX-License-Identifier: Apache-2.0
#include "engine/model/stated_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

Facade facade_of(const std::vector<double>& errors) {
  Facade facade;
  FacadeElement e;
  for (const double error : errors) e.edges.push_back({DrawnStatus::seen, 9, 0, error, 0});
  facade.elements = {e};
  return facade;
}

TEST(StatedErrors, EqualErrorsAreTheNumber) {
  EXPECT_NEAR(seen_error_95(facade_of({0.004, 0.004, 0.004})), 0.004, 1e-9);
  EXPECT_EQ(seen_error_95(Facade{}), 0);
}

TEST(StatedErrors, OfSeenEdgesAlone) {
  Facade facade = facade_of({0.01, 0.03});
  const double seen = seen_error_95(facade);
  EXPECT_GT(seen, 0.01);
  EXPECT_LT(seen, 0.03);
  for (const DrawnStatus status : {DrawnStatus::occluded, DrawnStatus::completed})
    facade.elements[0].edges.push_back({status, 0, 0, 3, 0});
  facade.elements[0].edges.push_back({DrawnStatus::by_hand, 0, 0, 0, 0});
  EXPECT_EQ(seen_error_95(facade), seen);
  facade.elements[0].edges = {{DrawnStatus::occluded, 0, 0, 3, 0}};
  EXPECT_EQ(seen_error_95(facade), 0);
}

// Normal errors of different size, each with its bound of 95 %: 95 % of all lie within the number, up to four binomial
// standard deviations.
TEST(StatedErrors, ContainsNineteenNormalErrorsOfTwenty) {
  Rng rng(11);
  const auto normal = [&] {
    return std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(2 * 3.14159265358979 * rng.uniform());
  };
  std::vector<double> bounds, errors;
  for (int i = 0; i < 20000; ++i) {
    bounds.push_back(0.002 * std::pow(100.0, rng.uniform()));
    errors.push_back(normal() * bounds.back() / 1.96);
  }
  const double limit = seen_error_95(facade_of(bounds));
  double within = 0;
  for (const double error : errors) within += std::abs(error) <= limit;
  EXPECT_NEAR(within / static_cast<double>(errors.size()), 0.95, 0.0062);
}

}  // namespace
}  // namespace ilot
