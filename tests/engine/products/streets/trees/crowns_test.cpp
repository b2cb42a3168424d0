// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/trees/crowns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/products/streets/trees/tree_shape.h"

namespace ilot {
namespace {

// Half ellipsoids of given heights and radii, in millimetres and cells.
struct Dome {
  double x, y, radius, height;
};

Image canopy(std::uint32_t width, std::uint32_t height, const std::vector<Dome>& domes) {
  Image image = filled_image(width, height, kNoHeight);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (const Dome& d : domes) {
        const double r = std::hypot(x - d.x, y - d.y) / d.radius;
        if (r > 1) continue;
        const auto top = static_cast<Height>(1000 * d.height * (0.5 + 0.5 * std::sqrt(1 - r * r)));
        Height& v = image.values[std::size_t{y} * width + x];
        v = std::max(v, top);
      }
  return image;
}

CrownParams crown_params() {
  CrownParams p;
  p.least_height = 3000;
  return p;
}

TEST(Crowns, ApartAreTwoAndOverlappingDomesAreToldByTheirPass) {
  const Image apart = canopy(60, 30, {{15, 15, 8, 10}, {42, 15, 8, 8}});
  EXPECT_EQ(find_crowns(apart, {}, crown_params()).regions.size(), 2u);
  const Image deep = canopy(60, 30, {{18, 15, 10, 10}, {36, 15, 10, 10}});  // a pass at 0.72 of the tops
  EXPECT_EQ(find_crowns(deep, {}, crown_params()).regions.size(), 2u);
  const Image shallow = canopy(60, 30, {{26, 15, 10, 10}, {32, 15, 10, 10}});  // at 0.98
  EXPECT_EQ(find_crowns(shallow, {}, crown_params()).regions.size(), 1u);
}

TEST(Crowns, TwoTrunksBelowOneTreetopSplitIt) {
  const Image dome = canopy(60, 30, {{30, 15, 14, 10}});
  const std::vector<TrunkCell> trunks{{22, 15}, {38, 15}};
  const CrownRegions crowns = find_crowns(dome, trunks, crown_params());
  ASSERT_EQ(crowns.regions.size(), 2u);
  EXPECT_NE(crowns.of[15 * 60 + 20], crowns.of[15 * 60 + 40]);
  std::set<int> owners{crowns.regions[0].trunk, crowns.regions[1].trunk};
  EXPECT_EQ(owners, (std::set<int>{0, 1}));
}

TEST(Crowns, ATrunkJoinsWhatIsOneTreeWithSeveralTreetops) {
  const Image two = canopy(60, 30, {{24, 15, 10, 10}, {38, 15, 10, 10}});  // a pass at 0.85
  EXPECT_EQ(find_crowns(two, {}, crown_params()).regions.size(), 2u);
  const std::vector<TrunkCell> trunk{{24, 15}};
  EXPECT_EQ(find_crowns(two, trunk, crown_params()).regions.size(), 1u);
}

TEST(Crowns, LowCellsAreInNoneAndEveryOtherCellIsInOne) {
  Image image = canopy(40, 40, {{12, 12, 9, 12}, {28, 28, 9, 7}, {30, 8, 6, 2}});
  const CrownRegions crowns = find_crowns(image, {}, crown_params());
  for (std::size_t i = 0; i < image.size(); ++i) EXPECT_EQ(crowns.of[i] != 0, image.values[i] >= 3000) << i;
  EXPECT_TRUE(find_crowns(filled_image(5, 5, kNoHeight), {}, crown_params()).regions.empty());
}

TEST(TreeShape, MeasuresOfACrown) {
  VegetationCells cells;
  cells.top = filled_image(10, 10, 5000), cells.low = filled_image(10, 10, 3000);
  cells.above = filled_image(10, 10, 5000), cells.points = filled_image(10, 10, 2);
  cells.bins = filled_image(10, 10, 0b1111000000);
  cells.top.values[33] = 7000;
  cells.low.values[55] = 0;  // the trunk
  std::vector<std::uint32_t> all(100);
  for (std::uint32_t i = 0; i < 100; ++i) all[i] = i;
  const TreeShape shape = tree_shape(cells, all, 5.5, 5.5, 1);
  EXPECT_EQ(shape.top, 7000);
  EXPECT_EQ(shape.base, 3000);
  EXPECT_EQ(shape.cells, 100u);
  EXPECT_EQ(shape.points, 200u);
  EXPECT_DOUBLE_EQ(shape.x, 5);
  EXPECT_DOUBLE_EQ(unseen_share(cells, all, 5, 5, 6, 9), 0);
  EXPECT_DOUBLE_EQ(unseen_share(cells, all, 5, 5, 4, 9), 2.0 / 6);
  const std::vector<std::uint32_t> one{0};  // a cell on one side of the middle
  EXPECT_DOUBLE_EQ(unseen_share(cells, one, 5, 5, 6, 9), 7.0 / 8);
}

}  // namespace
}  // namespace ilot
