// SPDX-License-Identifier: Apache-2.0
#include "engine/api/lattice_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/error.h"

namespace ilot {
namespace {

TEST(LatticePoints, StepIsTheRoundOneThatCoversTheBox) {
  const std::vector<double> low{0, 0}, high{700000, 700000};
  const auto step = [&](double length) {
    const std::vector<double> x{652000, 652000 + length};
    return lattice_step({x, low, high});
  };
  EXPECT_EQ(step(400), 0.0001);
  EXPECT_EQ(step(420), 0.0002);
  EXPECT_EQ(step(4190), 0.001);
  EXPECT_EQ(step(4200), 0.002);
  EXPECT_EQ(step(20000), 0.005);
}

// Whole millimetres at national coordinates stay whole, and each is found again at its index.
TEST(LatticePoints, MultiplesOfTheStepStayAsTheyAre) {
  std::vector<double> x, y, z;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(652000.125 + 0.001 * ((i * 7919) % 90001));
    y.push_back(6862000.5 + 0.001 * ((i * 104729) % 80021));
    z.push_back(-31.007 + 0.001 * (i % 977));
  }
  const LatticePoints p = lattice_points({x, y, z}, 0.001);
  ASSERT_EQ(p.given.size(), x.size());
  ASSERT_GE(p.x.size(), x.size() + 16);
  std::vector<int> seen(x.size(), 0);
  for (std::size_t i = 0; i < p.given.size(); ++i) {
    const std::uint32_t at = p.given[i];
    ++seen[at];
    EXPECT_EQ(p.x[i], std::round(p.x[i]));
    EXPECT_NEAR(p.origin.x + p.x[i] * p.step, x[at], 2e-9);
    EXPECT_NEAR(p.origin.y + p.y[i] * p.step, y[at], 2e-9);
    EXPECT_NEAR(p.origin.z + p.z[i] * p.step, z[at], 2e-9);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(x.size()));
}

TEST(LatticePoints, RoundingIsBoundedAndOffsetsFitTheKernels) {
  std::vector<double> x, y, z;
  for (int i = 0; i < 2000; ++i) {
    x.push_back(std::fmod(i * 1234.56789, 5000.0));
    y.push_back(std::fmod(i * 777.123, 4000.0));
    z.push_back(std::fmod(i * 3.14159, 60.0));
  }
  const LatticePoints p = lattice_points({x, y, z}, 0);
  for (std::size_t i = 0; i < p.given.size(); ++i) {
    const std::uint32_t at = p.given[i];
    const Vec3 placed = p.origin + p.step * Vec3{p.x[i], p.y[i], p.z[i]};
    EXPECT_LE(norm(placed - Vec3{x[at], y[at], z[at]}), kMostRounding * p.step * (1 + 1e-9));
    EXPECT_LE(std::abs(p.x[i]), kLatticeSteps / 2 + 1);
  }
}

TEST(LatticePoints, RefusesWhatItCannotHold) {
  const std::vector<double> none, one{1}, two{0, 4200}, bad{0, std::numeric_limits<double>::infinity()};
  EXPECT_THROW(lattice_step({none, none, none}), Error);
  EXPECT_THROW(lattice_step({two, two, one}), Error);
  EXPECT_THROW(lattice_step({two, two, bad}), Error);
  EXPECT_THROW(lattice_points({two, two, two}, 0.001), Error);
  EXPECT_THROW(lattice_points({two, two, two}, -1), Error);
  EXPECT_EQ(lattice_points({one, one, one}, 0).given.size(), 1u);
}

}  // namespace
}  // namespace ilot
