// SPDX-License-Identifier: Apache-2.0
#include "training/feature_selection.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <boost/math/distributions/fisher_f.hpp>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

struct Sample {
  std::size_t features;
  std::vector<double> values;
  std::vector<std::uint32_t> classes;
};

double normal(Rng& rng) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += rng.uniform();
  return sum;
}

// Three classes: feature 1 tells them best, 3 helps, 0 is noise, 2 is the sum of 1 and 3, 4 never changes.
Sample three_classes(std::size_t n, std::uint64_t seed) {
  Sample sample{5, {}, {}};
  Rng rng(seed);
  for (std::size_t i = 0; i < n; ++i) {
    const auto c = static_cast<std::uint32_t>(rng.below(3));
    const double one = 3.0 * c + normal(rng), three = (c == 1 ? 2.5 : 0.0) + normal(rng);
    for (const double v : {normal(rng), one, one + three, three, 7.0}) sample.values.push_back(v);
    sample.classes.push_back(c * 10);
  }
  return sample;
}

// Oracle: determinants by Eigen over the definition.
double wilks_lambda(const Sample& s, const std::vector<std::size_t>& chosen) {
  const auto k = static_cast<Eigen::Index>(chosen.size());
  const auto scatter = [&](const std::vector<std::size_t>& rows) {
    Eigen::MatrixXd x(static_cast<Eigen::Index>(rows.size()), k);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (Eigen::Index j = 0; j < k; ++j)
        x(static_cast<Eigen::Index>(r), j) = s.values[rows[r] * s.features + chosen[static_cast<std::size_t>(j)]];
    const Eigen::MatrixXd centred = x.rowwise() - x.colwise().mean();
    return Eigen::MatrixXd(centred.transpose() * centred);
  };
  std::vector<std::size_t> all;
  Eigen::MatrixXd within = Eigen::MatrixXd::Zero(k, k);
  for (const std::uint32_t c : {0u, 10u, 20u}) {
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < s.classes.size(); ++r)
      if (s.classes[r] == c) rows.push_back(r);
    within += scatter(rows);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return within.determinant() / scatter(all).determinant();
}

TEST(FeatureSelection, EqualsTheDefinitionStepByStep) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Sample s = three_classes(200, seed);
    const auto got = select_features(s.values, s.classes, s.features, 0.01);
    std::vector<std::size_t> chosen;
    double before = 1;
    for (const SelectedFeature& step : got) {
      double least = 2;
      for (std::size_t j = 0; j < 4; ++j) {  // 4 never changes
        if (std::count(chosen.begin(), chosen.end(), j) != 0) continue;
        auto with = chosen;
        with.push_back(j);
        const bool dependent = std::count(with.begin(), with.end(), 1) + std::count(with.begin(), with.end(), 2) +
                                   std::count(with.begin(), with.end(), 3) ==
                               3;
        if (!dependent) least = std::min(least, wilks_lambda(s, with));
      }
      chosen.push_back(step.feature);
      EXPECT_NEAR(wilks_lambda(s, chosen) / least, 1, 1e-9);
      EXPECT_NEAR(step.lambda / least, 1, 1e-9);
      const auto d2 = static_cast<double>(200 - 3 - (chosen.size() - 1));
      const double f = d2 / 2 * (before / least - 1);
      EXPECT_NEAR(step.f / f, 1, 1e-7);
      EXPECT_NEAR(step.p, boost::math::cdf(complement(boost::math::fisher_f(2, d2), f)), 1e-9);
      EXPECT_LT(step.p, 0.01);
      before = least;
    }
    ASSERT_GE(got.size(), 2u);
    EXPECT_EQ(std::count(chosen.begin(), chosen.end(), 4), 0);
    EXPECT_LE(got.size(), 3u);  // two of the three that depend on each other, seldom the noise
  }
}

TEST(FeatureSelection, NoiseIsNotSelected) {
  Rng rng(8);
  int picked = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<double> values;
    std::vector<std::uint32_t> classes;
    for (int i = 0; i < 60; ++i) {
      values.push_back(normal(rng));
      classes.push_back(static_cast<std::uint32_t>(i % 4));
    }
    picked += static_cast<int>(select_features(values, classes, 1, 0.01).size());
  }
  EXPECT_LE(picked, 10);  // one in a hundred by design: 3 expected, 10 has probability below 0.001
}

TEST(FeatureSelection, NothingToSeparate) {
  const std::vector<double> values{1, 2, 3};
  EXPECT_TRUE(select_features(values, std::vector<std::uint32_t>{1, 1, 1}, 1).empty());
  EXPECT_TRUE(select_features(values, std::vector<std::uint32_t>{1, 2, 3}, 1).empty());
  EXPECT_TRUE(select_features({}, {}, 1).empty());
  // Perfectly told apart: lambda 0, and no division by it.
  const auto got =
      select_features(std::vector<double>{0, 0, 0, 5, 5, 5}, std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1}, 1);
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(got[0].lambda, 0);
  EXPECT_LT(got[0].p, 1e-100);
}

}  // namespace
}  // namespace ilot
