// SPDX-License-Identifier: Apache-2.0
#include "engine/settings/nearest_name.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

TEST(NearestName, CountsLetters) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", "abc"), 0u);
  EXPECT_EQ(edit_distance("rnu", "run"), 1u);
  EXPECT_EQ(edit_distance("epsilom", "epsilon"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(NearestName, SuggestsWhatWasProbablyMeant) {
  const std::vector<std::string> names{"run", "info", "convert", "--products", "--product-list"};
  EXPECT_EQ(nearest_name("rnu", names), "run");
  EXPECT_EQ(nearest_name("conv", names), "convert");
  EXPECT_EQ(nearest_name("--product", names), "--products");  // the earlier of two that begin so
  EXPECT_EQ(nearest_name("pipeline", names), std::nullopt);
  EXPECT_EQ(nearest_name("", names), std::nullopt);
  EXPECT_EQ(nearest_name("x", names), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100000, 'r'), names), std::nullopt);
  EXPECT_EQ(nearest_name("run", {}), std::nullopt);
  EXPECT_EQ(did_you_mean("inof", names), "; did you mean 'info'?");
  EXPECT_EQ(did_you_mean("pipeline", names), "");
}

}  // namespace
}  // namespace ilot
