// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/step_gains.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/planes/step_gains_body.h"
#include "tests/support/instruction_sets.h"

namespace ilot {
namespace {

struct Points {
  std::vector<double> x, y, z, residual;
  PlaneInverse inverse;
};

// The normal equations of a plane through all points, and what it leaves.
void fit(Points& p) {
  Eigen::MatrixXd rows(p.x.size(), 3);
  Eigen::VectorXd z(p.x.size());
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rows.row(row) << 1, p.x[i], p.y[i];
    z(row) = p.z[i];
  }
  const Eigen::Matrix3d m = (rows.transpose() * rows).inverse();
  const Eigen::VectorXd left = z - rows * (m * (rows.transpose() * z));
  p.inverse = {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
  p.residual.assign(left.begin(), left.end());
}

// Points at random in a circle of 1 m, on a slope with noise and a step of `height` where x > `edge`.
Points points_of(std::size_t n, double height, double edge, double noise) {
  Points p;
  Rng rng(n, 5);
  while (p.x.size() < n) {
    const double x = 2 * rng.uniform() - 1, y = 2 * rng.uniform() - 1;
    if (x * x + y * y > 1) continue;
    p.x.push_back(x), p.y.push_back(y);
    p.z.push_back(0.03 * x - 0.01 * y + (x > edge ? height : 0) + noise * (rng.uniform() - 0.5));
  }
  fit(p);
  return p;
}

std::vector<StepDirection> directions(std::size_t n) {
  std::vector<StepDirection> out;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = 3.14159265358979 * static_cast<double>(k) / static_cast<double>(n);
    out.push_back({std::cos(turn), std::sin(turn)});
  }
  return out;
}

StepGains gains_of(const Points& p, const std::vector<StepDirection>& tried, double least) {
  StepGains out;
  out.gain.fill(-7), out.residual.fill(-7);
  step_gains({p.x, p.y, p.residual, 1, p.inverse, least}, tried, out);
  return out;
}

// How much less the squares are where a column of 0 and 1 is fitted too.
double gain_of_column(const Points& p, const std::vector<bool>& beyond) {
  Eigen::MatrixXd rows(p.x.size(), 4);
  Eigen::VectorXd z(p.x.size());
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rows.row(row) << 1, p.x[i], p.y[i], beyond[i] ? 1.0 : 0.0;
    z(row) = p.residual[i];
  }
  const Eigen::VectorXd found = rows.colPivHouseholderQr().solve(z);
  return z.squaredNorm() - (z - rows * found).squaredNorm();
}

TEST(StepGains, EqualTheSquaresThatAStepSaves) {
  for (const std::size_t n : {12u, 60u, 300u}) {
    const Points p = points_of(n, 0.1, 0.2, 0.02);
    const auto tried = directions(5);
    const StepGains got = gains_of(p, tried, 4);
    for (std::size_t k = 0; k < tried.size(); ++k)
      for (std::size_t b = 1; b < kStepStrips; ++b) {
        std::vector<bool> beyond(n);
        std::size_t count = 0, own = 0;
        for (std::size_t i = 0; i < n; ++i) {
          const double strip = std::floor((p.x[i] * tried[k].x + p.y[i] * tried[k].y + 1) * kStepStrips / 2);
          beyond[i] = strip >= static_cast<double>(b);
          count += beyond[i], own += strip == static_cast<double>(b);
        }
        const double gain = got.gain[k * kStepStrips + b];
        if (own == 0 || count < 4 || n - count < 4)
          EXPECT_EQ(gain, 0);
        else
          EXPECT_NEAR(gain, gain_of_column(p, beyond), 1e-9) << n << " " << k << " " << b;
      }
  }
}

TEST(StepGains, AreGreatestAlongTheStep) {
  const Points p = points_of(400, 0.1, 0.25, 0.01);
  const auto tried = directions(kStepDirections);
  const StepGains got = gains_of(p, tried, 6);
  const auto best = static_cast<std::size_t>(std::max_element(got.gain.begin(), got.gain.end()) - got.gain.begin());
  EXPECT_EQ(best / kStepStrips, 0u);  // along x
  EXPECT_NEAR(static_cast<double>(best % kStepStrips) * 2 / kStepStrips - 1, 0.25, 2.0 / kStepStrips);
  EXPECT_GT(got.residual[best], 0);  // what is beyond is higher
}

TEST(StepGains, WriteNoMoreThanTheDirections) {
  const StepGains got = gains_of(points_of(50, 0.1, 0, 0.01), directions(4), 6);
  for (std::size_t i = 4 * kStepStrips; i < got.gain.size(); ++i) EXPECT_EQ(got.gain[i], -7);
}

TEST(StepGains, AreTheSameBitsWithEveryInstructionSet) {
  for (const std::size_t n : {5u, 7u, 100u})
    for (const std::size_t count : {1u, 4u, 16u}) {
      const Points p = points_of(n, 0.05, -0.1, 0.03);
      const auto tried = directions(count);
      const auto with = [&](simd::Isa isa) {
        simd::StepGainsArgs args{};
        std::vector<double> ux(kStepDirections), uy(kStepDirections), strips(count * kStepStrips * 4, 0.0);
        for (std::size_t k = 0; k < count; ++k) ux[k] = tried[k].x, uy[k] = tried[k].y;
        const PlaneInverse& m = p.inverse;
        const double inverse[] = {m.a, m.b, m.c, m.d, m.e, m.f};
        std::vector<double> gain(count * kStepStrips), beyond(gain.size());
        args = {p.x.data(), p.y.data(), p.residual.data(), n,           ux.data(),    uy.data(), count, 1, 16,
                3,          inverse,    strips.data(),     gain.data(), beyond.data()};
        simd::kStepGains.of(isa).step_gains(args);
        gain.insert(gain.end(), beyond.begin(), beyond.end());
        return gain;
      };
      for (const simd::Isa isa : test::vector_isas()) EXPECT_EQ(with(isa), with(simd::Isa::baseline)) << n;
    }
}

}  // namespace
}  // namespace ilot
