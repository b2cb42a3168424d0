// SPDX-License-Identifier: Apache-2.0
#include "engine/model/stated_errors.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(StatedErrors, OfSeenEdgesAlone) {
  Facade facade;
  EXPECT_EQ(seen_error_95(facade), 0);
  FacadeElement e;
  for (int i = 1; i <= 100; ++i) e.edges.push_back({DrawnStatus::seen, 9, 0, 0.001 * i, 0});
  e.edges.push_back({DrawnStatus::occluded, 0, 0, 3, 0});
  e.edges.push_back({DrawnStatus::completed, 0, 0, 3, 0});
  e.edges.push_back({DrawnStatus::by_hand, 0, 0, 0, 0});
  facade.elements = {e};
  EXPECT_DOUBLE_EQ(seen_error_95(facade), 0.095);
  facade.elements[0].edges = {{DrawnStatus::occluded, 0, 0, 3, 0}};
  EXPECT_EQ(seen_error_95(facade), 0);
}

}  // namespace
}  // namespace ilot
