// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/roof_labels.h"

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
  std::vector<std::vector<LabelRun>> runs(50);  // of units, put aside in another order than theirs
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> points(runs.size());
  for (std::uint32_t n = 0; n < runs.size(); ++n) {
    const std::uint32_t unit = (n * 7) % 50;
    for (int run = 0; run < 4; ++run) {
      const auto block = static_cast<std::uint32_t>(rng.below(store.blocks().size()));
      std::vector<SitePointLabel> part;
      for (int i = 0; i < 10; ++i) {
        part.push_back(
            {static_cast<std::uint32_t>(rng.below(store.blocks()[block].points)), unit % 5, PointLabel::roof});
        points[unit].push_back({block, part.back().point});
      }
      runs[unit].push_back(labels.store_labels(block, part));
    }
  }
  for (std::uint32_t unit = 0; unit < runs.size(); ++unit) {
    labels.add(unit + 1, 100 * unit + 1, runs[unit]);
    for (const auto& at : points[unit]) wanted.emplace(at, unit);
  }
  labels.write_columns({}, [&](std::uint32_t block) {
    return std::vector<PointLabel>(store.blocks()[block].points, PointLabel::ground);
  });
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    const auto column = store.read(b, columns::kRoof);
    for (std::uint32_t i = 0; i < column.size(); ++i) {
      const auto entry = wanted.find({b, i});
      const bool known = entry != wanted.end();
      EXPECT_EQ(column[i].unit, known ? entry->second + 1 : 0);
      EXPECT_EQ(column[i].plane, known && entry->second % 5 > 0 ? 100 * entry->second + entry->second % 5 : 0);
      EXPECT_EQ(column[i].label, known ? PointLabel::roof : PointLabel::ground);
    }
  }
}

TEST(RoofLabels, TheUnitWithTheNearestOutlineHasThePoint) {
  const test::CloudStore cloud(test::points_over_tiles(500, 3), {512, 1u << 20, 1});
  const Store& store = cloud.store();
  RoofLabels labels(store);
  const auto add = [&](std::uint32_t unit, std::vector<SitePointLabel> given) {
    labels.add(unit, unit, std::vector<LabelRun>{labels.store_labels(0, given)});
  };
  add(1, {{0, 0, PointLabel::roof, 9}, {1, 0, PointLabel::roof, 0}, {2, 0, PointLabel::roof, 5}});
  add(2, {{0, 0, PointLabel::wall, 0}, {1, 0, PointLabel::wall, 0}, {2, 0, PointLabel::wall, 5}});
  labels.write_columns(
      {}, [&](std::uint32_t block) { return std::vector<PointLabel>(store.blocks()[block].points, PointLabel::none); });
  const auto column = store.read(0, columns::kRoof);
  EXPECT_EQ(column[0].unit, 2u) << "in its outline";
  EXPECT_EQ(column[0].label, PointLabel::wall);
  EXPECT_EQ(column[1].unit, 1u) << "in both outlines: the first";
  EXPECT_EQ(column[2].unit, 1u) << "as near to both";
}

}  // namespace
}  // namespace ilot
