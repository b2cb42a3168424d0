// SPDX-License-Identifier: Apache-2.0
#include "kernels/classifiers/radial_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/classifiers/radial_sums_body.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "tests/support/instruction_sets.h"

namespace ilot {
namespace {

struct Case {
  std::vector<double> vectors, weights, rows;
  RadialVectors model;
};

// Distances from 0 to far beyond where kernels vanish.
Case make_case(std::size_t vectors, std::size_t rows, std::size_t dimensions, std::size_t sums, double gamma) {
  Case c;
  Rng rng(vectors * 1000 + rows, 3);
  for (std::size_t i = 0; i < vectors * dimensions; ++i) c.vectors.push_back(6 * rng.uniform() - 3);
  for (std::size_t i = 0; i < vectors * sums; ++i) c.weights.push_back(2 * rng.uniform() - 1);
  for (std::size_t i = 0; i < rows * dimensions; ++i) c.rows.push_back(6 * rng.uniform() - 3);
  for (std::size_t i = 0; i < std::min(c.rows.size(), c.vectors.size()) / 2; ++i) c.rows[i] = c.vectors[i];
  c.model = {dimensions, sums, gamma, c.vectors, c.weights};
  return c;
}

struct Sums {
  std::vector<double> totals, nearest;
  bool operator==(const Sums&) const = default;
};

Sums sums_of(const Case& c) {
  const std::size_t rows = c.rows.size() / c.model.dimensions;
  Sums out{std::vector<double>(rows * c.model.sums, 7), std::vector<double>(rows, 7)};
  radial_sums(c.model, c.rows, out.totals, out.nearest);
  return out;
}

void expect_naive(const Case& c) {
  const Sums got = sums_of(c);
  const std::size_t d = c.model.dimensions, k = c.model.sums, n = c.vectors.size() / d;
  for (std::size_t r = 0; r < got.nearest.size(); ++r) {
    std::vector<double> sums(k, 0);
    double nearest = 0, size = 0;
    for (std::size_t v = 0; v < n; ++v) {
      double d2 = 0;
      for (std::size_t i = 0; i < d; ++i) d2 += std::pow(c.rows[r * d + i] - c.vectors[v * d + i], 2);
      const double kernel = std::exp(-c.model.gamma * d2);
      nearest = std::max(nearest, kernel);
      size += kernel;
      for (std::size_t s = 0; s < k; ++s) sums[s] += c.weights[v * k + s] * kernel;
    }
    EXPECT_NEAR(got.nearest[r], nearest, 1e-12 * nearest + 1e-300);
    for (std::size_t s = 0; s < k; ++s) EXPECT_NEAR(got.totals[r * k + s], sums[s], 1e-12 * size + 1e-300);
  }
}

TEST(RadialSums, EqualTheNaiveLoop) {
  for (const std::size_t vectors : {1u, 2u, 63u, 64u, 65u, 200u})
    for (const std::size_t rows : {1u, 7u, 16u, 17u, 33u})
      for (const double gamma : {0.0, 0.01, 1.0, 100.0}) expect_naive(make_case(vectors, rows, 5, 3, gamma));
  expect_naive(make_case(70, 20, 1, 1, 0.5));
  expect_naive(make_case(70, 20, 26, 7, 0.03));
}

TEST(RadialSums, NoVectorsAndNoRows) {
  const Sums none = sums_of(make_case(0, 3, 2, 2, 1));
  EXPECT_EQ(none.totals, std::vector<double>(6, 0.0));
  EXPECT_EQ(none.nearest, std::vector<double>(3, 0.0));
  EXPECT_TRUE(sums_of(make_case(3, 0, 2, 2, 1)).totals.empty());
}

TEST(RadialSums, AtTheVectorItself) {
  const Case c{{1, 2, 3}, {5}, {1, 2, 3}, {}};
  Sums out{{0}, {0}};
  radial_sums({3, 1, 0.5, c.vectors, c.weights}, c.rows, out.totals, out.nearest);
  EXPECT_EQ(out.totals[0], 5);
  EXPECT_EQ(out.nearest[0], 1);
}

TEST(RadialSums, WhatStandsBesideDoesNotShow) {
  const Case many = make_case(100, 40, 6, 4, 0.1);
  const Sums all = sums_of(many);
  for (std::size_t r = 0; r < 40; ++r) {
    Case one = many;
    one.rows.assign(many.rows.begin() + static_cast<std::ptrdiff_t>(6 * r),
                    many.rows.begin() + static_cast<std::ptrdiff_t>(6 * r + 6));
    const Sums alone = sums_of(one);
    EXPECT_EQ(alone.nearest[0], all.nearest[r]);
    for (std::size_t s = 0; s < 4; ++s) EXPECT_EQ(alone.totals[s], all.totals[4 * r + s]);
  }
}

TEST(RadialSums, SameBitsForEveryInstructionSet) {
  for (const double gamma : {0.004, 0.3, 20.0}) {
    Case c = make_case(150, 16, 9, 5, gamma);
    const auto run = [&](simd::Isa isa) {
      Sums out{std::vector<double>(5 * simd::kRadialRows), std::vector<double>(simd::kRadialRows)};
      simd::kRadialSums.of(isa).radial_sums(
          {c.rows.data(), c.vectors.data(), c.weights.data(), 150, 9, 5, gamma, out.totals.data(), out.nearest.data()});
      return out;
    };
    const Sums baseline = run(simd::Isa::baseline);
    for (const simd::Isa isa : test::vector_isas()) EXPECT_EQ(run(isa), baseline) << simd::name_of(isa);
  }
}

}  // namespace
}  // namespace ilot
