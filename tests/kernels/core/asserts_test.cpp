// SPDX-License-Identifier: Apache-2.0
// Compiled where ILOT_ASSERTS is on: the library that is linked must have its asserts then, whatever flags came first.
#include <gtest/gtest.h>

#include "kernels/morphology/h_maxima.h"

namespace ilot {
namespace {

TEST(AssertsDeathTest, BrokenPreconditionsEndTheProgram) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // other tests of the executable start threads
  EXPECT_DEATH(h_maxima(Image{}, -1, Adjacency::eight), "Assertion");
}

}  // namespace
}  // namespace ilot
