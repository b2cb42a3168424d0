// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/scene_buildings.h"

#include <gtest/gtest.h>

#include "engine/deliverables/report/building_tiles.h"
#include "engine/report/product_files.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

Building slab() {
  Building b;
  b.vertices = {{700000.123, 6600000.5, 10},
                {700010, 6600000.5, 10},
                {700010, 6600020, 10},
                {1, 2, 3},
                {700000, 6600020, 12.345}};
  b.surfaces = {{SurfaceKind::roof, 7, {{0, 1, 4}}}, {SurfaceKind::ground, 0, {{0, 1, 2, 4}, {1, 2, 4}}}};
  return b;
}

TEST(SceneBuildings, ShapesComeBackToTheCentimetre) {
  const SceneFrame frame{{700000, 6600000, 0}, 0.3048};
  const Building before = slab(), after = unpacked_shape(packed_shape(before, frame), frame);
  ASSERT_EQ(after.surfaces.size(), 2u);
  ASSERT_EQ(after.vertices.size(), 4u);  // those that faces use
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(after.surfaces[s].kind, before.surfaces[s].kind);
    ASSERT_EQ(after.surfaces[s].rings.size(), before.surfaces[s].rings.size());
    for (std::size_t r = 0; r < before.surfaces[s].rings.size(); ++r) {
      ASSERT_EQ(after.surfaces[s].rings[r].size(), before.surfaces[s].rings[r].size());
      for (std::size_t i = 0; i < before.surfaces[s].rings[r].size(); ++i) {
        const Vec3 was = before.vertices[before.surfaces[s].rings[r][i]],
                   is = after.vertices[after.surfaces[s].rings[r][i]];
        EXPECT_LT(norm(was - is) * frame.metres_per_unit, 0.009);
      }
    }
  }
}

BuildingRow row_at(double x, double y) {
  BuildingRow row;
  row.id = "a";
  row.shape = packed_shape(slab(), {{700000, 6600000, 0}, 1});
  row.middle = {x, y, 0};
  return row;
}

TEST(BuildingTiles, FewAreInThePageAndManyBesideIt) {
  const TemporaryFolder folder;
  std::vector<BuildingRow> rows;
  for (int i = 0; i < 300; ++i) rows.push_back(row_at(i % 20, i / 20));
  const BuildingTiles few = write_building_tiles(folder.path(), rows);
  ASSERT_EQ(few.about.size(), 1u);
  EXPECT_EQ(few.about[0]["buildings"], 300);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / kReportTiles));
  for (BuildingRow& row : rows) row.shape += std::string(60000, '\0');  // as if they had many corners
  const BuildingTiles many = write_building_tiles(folder.path(), rows);
  EXPECT_GT(many.about.size(), 20u);
  EXPECT_TRUE(many.elements.empty());
  std::uint64_t buildings = 0, bytes = 0;
  for (const auto& tile : many.about) {
    buildings += tile["buildings"].get<std::uint64_t>();
    bytes += std::filesystem::file_size(folder.path() / tile["file"].get<std::string>());
  }
  EXPECT_EQ(buildings, 300u);
  EXPECT_EQ(bytes, many.bytes_beside);
  folder.put("report-tiles/mine.txt", "mine");
  remove_building_tiles(folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / kReportTiles / "mine.txt"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / kReportTiles / "models-0.js"));
}

}  // namespace
}  // namespace ilot
