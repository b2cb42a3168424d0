// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/reliability.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

TEST(Reliability, CalibratedStatementsHaveNoError) {
  std::vector<JudgedProbability> statements;
  for (int i = 0; i < 100; ++i) statements.push_back({0.75, i < 75});
  const Reliability r = reliability(statements);
  EXPECT_NEAR(r.calibration_error, 0, 1e-12);
  EXPECT_EQ(r.bins[7].count, 100u);
  EXPECT_NEAR(r.bins[7].right, 0.75, 1e-12);
  EXPECT_NEAR(r.bins[7].mean_probability, 0.75, 1e-12);
}

TEST(Reliability, TheErrorIsTheMeanOverAllStatements) {
  // 30 statements at 0.95 of which a third is right, and 10 at 0.05 that are all wrong.
  std::vector<JudgedProbability> statements;
  for (int i = 0; i < 30; ++i) statements.push_back({0.95, i < 10});
  for (int i = 0; i < 10; ++i) statements.push_back({0.05, false});
  EXPECT_NEAR(reliability(statements).calibration_error, (30 * (0.95 - 1.0 / 3) + 10 * 0.05) / 40, 1e-12);
}

TEST(Reliability, EveryProbabilityHasABin) {
  const std::vector<JudgedProbability> statements{{0, true}, {0.1, true}, {1, true}};
  const Reliability r = reliability(statements);
  EXPECT_EQ(r.bins[0].count, 1u);
  EXPECT_EQ(r.bins[1].count, 1u);
  EXPECT_EQ(r.bins[9].count, 1u);
  EXPECT_EQ(reliability({}).calibration_error, 0);
}

}  // namespace
}  // namespace ilot
