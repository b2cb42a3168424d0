// SPDX-License-Identifier: Apache-2.0
#include "engine/run/roof_labels.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

TEST(RoofLabels, EveryPointHasTheLabelOfItsFirstUnit) {
  const test::CloudStore cloud(test::points_over_tiles(5000, 3), {512, 1u << 20, 1});
  const Store& store = cloud.store();
  RoofLabels labels(store);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> wanted;
  Rng rng(8);
  for (std::uint32_t batch = 0, unit = 1; batch < 5; ++batch) {
    std::vector<LabelledPoint> points;
    for (; unit % 10 != 0; ++unit) {
      for (int n = 0; n < 40; ++n) {
        const auto block = static_cast<std::uint32_t>(rng.below(store.blocks().size()));
        const auto point = static_cast<std::uint32_t>(rng.below(store.blocks()[block].points));
        points.push_back({block, point, {unit, unit + 100, PointLabel::roof}});
        wanted.emplace(std::pair{block, point}, unit);
      }
    }
    ++unit;
    labels.add(std::move(points));
  }
  labels.add({});
  labels.write_columns({}, [&](std::uint32_t block) {
    return std::vector<PointLabel>(store.blocks()[block].points, PointLabel::ground);
  });
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    const auto column = store.read(b, columns::kRoof);
    for (std::uint32_t i = 0; i < column.size(); ++i) {
      const auto entry = wanted.find({b, i});
      const std::uint32_t unit = entry == wanted.end() ? 0 : entry->second;
      EXPECT_EQ(column[i].unit, unit);
      EXPECT_EQ(column[i].plane, unit == 0 ? 0 : unit + 100);
      EXPECT_EQ(column[i].label, unit == 0 ? PointLabel::ground : PointLabel::roof);
    }
  }
}

}  // namespace
}  // namespace ilot
