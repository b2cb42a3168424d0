// SPDX-License-Identifier: Apache-2.0
// Compiled where ILOT_ASSERTS is on: the library that is linked must have its asserts then, whatever flags came first.
#include <gtest/gtest.h>

#include "kernels/core/f_distribution.h"

namespace ilot {
namespace {

TEST(AssertsDeathTest, BrokenPreconditionsEndTheProgram) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // other tests of the executable start threads
  EXPECT_DEATH(f_upper_tail(1.0, 0, 1), "Assertion");
}

}  // namespace
}  // namespace ilot
