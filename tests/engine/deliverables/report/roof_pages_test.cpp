// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/roof_pages.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

BuildingRow row_of(const char* quality, std::uint64_t points) {
  BuildingRow row;
  row.quality = quality;
  row.points = points;
  return row;
}

TEST(RoofPages, BuildingsWithoutPointsAreNotDoubtful) {
  const std::vector<BuildingRow> rows{row_of("good", 9), row_of("none", 0), row_of("bad", 9), row_of("none", 2)};
  EXPECT_EQ(most_doubtful(rows, 9), (std::vector<std::size_t>{2, 3, 0}));
}

}  // namespace
}  // namespace ilot
