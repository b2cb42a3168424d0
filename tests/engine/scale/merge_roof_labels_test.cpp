// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge/merge_roof_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/columns/point_roles.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/scale/parts/roof_label_records.h"
#include "engine/scale/records.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// Labels of points that many buildings want, as buildings give them: runs of one block, with all distances.
std::vector<std::vector<LabelRun>> labels_of_buildings(const Store& store, RoofLabels& labels, std::size_t buildings) {
  Rng rng(8);
  std::vector<std::vector<LabelRun>> runs(buildings);
  for (auto& runs_of_one : runs)
    for (int run = 0; run < 4; ++run) {
      const auto block = static_cast<std::uint32_t>(rng.below(store.blocks().size()));
      std::vector<SitePointLabel> part;
      for (std::uint32_t point = 0; point < store.blocks()[block].points; ++point)
        if (rng.below(5) == 0)
          part.push_back({point, static_cast<std::uint32_t>(rng.below(4)), PointLabel::roof,
                          static_cast<std::uint8_t>(rng.below(3))});
      runs_of_one.push_back(labels.store_labels(block, part));
    }
  return runs;
}

TEST(MergeRoofLabels, GivesTheLabelsOfOneStoreInAnyBlocks) {
  const std::vector<Index3> points = test::points_over_tiles(5000, 3);  // some places have many points
  const test::CloudStore one(points, {512, 1u << 20, 1}), merged(points, {3000, 1u << 20, 1});
  ASSERT_NE(one.store().blocks().size(), merged.store().blocks().size());
  constexpr std::uint32_t kBuildings = 30, kAreas = 3, kPlanes = 10;
  RoofLabels labels(one.store());
  const auto runs = labels_of_buildings(one.store(), labels, kBuildings);
  for (std::uint32_t i = 0; i < kBuildings; ++i) labels.add(i + 1, kPlanes * i + 1, runs[i]);
  labels.write_columns({}, [&](std::uint32_t block) {
    return std::vector<PointLabel>(one.store().blocks()[block].points, PointLabel::ground);
  });

  fs::create_directories(one.folder() / "labels");
  MergedRoofs roofs;
  std::vector<std::uint64_t> areas;
  for (std::uint32_t area = 0; area < kAreas; ++area) {
    areas.push_back(area + 1);
    RecordFileWriter file(one.folder() / "labels" / std::to_string(area + 1), {{"kind", "part"}});
    std::vector<BuildingNumbers>& numbers = roofs.numbers.emplace_back();
    for (std::uint32_t i = area; i < kBuildings; i += kAreas) {
      for (const LabelRun& run : runs[i])
        file.add(record_of(stored_labels(one.store(), static_cast<std::uint32_t>(numbers.size()), run)));
      numbers.push_back({i + 1, kPlanes * i + 1});
    }
    file.finish();
  }
  for (std::uint32_t b = 0; b < merged.store().blocks().size(); ++b)
    merged.store().write(b, columns::kRole,
                         std::vector<PointRole>(merged.store().blocks()[b].points, PointRole::ground));
  merge_roof_labels(merged.store(), one.folder() / "labels", areas, roofs, {});

  const auto wanted = test::whole_column(one.store(), columns::kRoof);
  const auto found = test::whole_column(merged.store(), columns::kRoof);
  ASSERT_EQ(found.size(), wanted.size());
  EXPECT_TRUE(std::ranges::equal(found, wanted, [](const RoofLabel& a, const RoofLabel& b) {
    return a.unit == b.unit && a.plane == b.plane && a.label == b.label;
  }));
  EXPECT_GT(std::ranges::count_if(found, [](const RoofLabel& l) { return l.unit > 0; }), 100);
}

TEST(MergeRoofLabels, LeavesOutPointsThatABlockDoesNotHave) {
  const std::vector<std::uint64_t> block{3, 5, 5, 5, 9};
  const std::vector<std::uint64_t> codes{2, 3, 5, 5, 9, 9, 11};
  std::vector<SitePointLabel> labels(codes.size());
  labels[3].point = 2;  // the third at its place
  labels[5].point = 1;  // a second that is not there
  find_points(block, codes, labels);
  std::vector<std::uint32_t> numbers;
  for (const SitePointLabel& label : labels) numbers.push_back(label.point);
  EXPECT_EQ(numbers, (std::vector<std::uint32_t>{0, 1, 3, 4}));
}

}  // namespace
}  // namespace ilot
