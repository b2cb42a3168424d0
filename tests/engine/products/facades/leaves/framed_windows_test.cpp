// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/framed_windows.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

constexpr double kMostFrameDepth = 0.3, kAlikeFrames = 0.04, kCellOfFrames = 0.03;

FoundRectangle rectangle(const Box2& box, double depth = 0, double error = 0.01) {
  FoundRectangle r;
  r.side(Side::left) = {box.u0, error}, r.side(Side::right) = {box.u1, error};
  r.side(Side::bottom) = {box.v0, error}, r.side(Side::top) = {box.v1, error};
  r.depth = depth;
  return r;
}

std::vector<ShutterLeaf> framed(std::vector<FoundRectangle>& relief, std::vector<FoundRectangle>& openings) {
  return find_framed_windows(kMostFrameDepth, kAlikeFrames, kCellOfFrames, relief, openings);
}

TEST(FramedWindows, APaneAsWideAsItsFrameGetsItsHeight) {
  std::vector<FoundRectangle> relief{rectangle({1, 1.8, 1, 2.8}, 0.05)};
  std::vector<FoundRectangle> openings{rectangle({1.01, 1.79, 1.02, 1.8})};
  EXPECT_TRUE(framed(relief, openings).empty());
  EXPECT_TRUE(relief.empty());
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_DOUBLE_EQ(openings[0].at(Side::top), 2.8);
  EXPECT_GT(openings[0].error(Side::top), 0.01);
}

TEST(FramedWindows, SurroundsAndStripsOverStoreysAreNoFrames) {
  const Box2 opening{1, 1.8, 1, 2.8};
  for (const Box2& plate : {opening.grown(0.15), Box2{1, 1.8, 0, 9}}) {
    std::vector<FoundRectangle> relief{rectangle(plate, 0.05)}, openings{rectangle(opening)};
    framed(relief, openings);
    EXPECT_EQ(relief.size(), 1u);
    EXPECT_DOUBLE_EQ(openings[0].at(Side::top), 2.8);
  }
}

TEST(FramedWindows, APlateOfTheSizeOfWindowsInItsRowOrColumnHidesOne) {
  const FoundRectangle window = rectangle({1, 1.8, 1, 2.8});
  std::vector<FoundRectangle> relief{rectangle({4, 4.8, 1, 2.8}, 0.05), rectangle({4, 4.8, 4, 5.8}, 0.2)};
  std::vector<FoundRectangle> openings{window};
  const std::vector<ShutterLeaf> leaves = framed(relief, openings);
  ASSERT_EQ(openings.size(), 3u);  // the second one is in the column of the first
  EXPECT_DOUBLE_EQ(openings[2].at(Side::bottom), 4);
  EXPECT_EQ(openings[2].depth, 0);
  ASSERT_EQ(leaves.size(), 1u);
  EXPECT_EQ(leaves[0].state, LeafState::closed);
  ASSERT_EQ(relief.size(), 1u);  // what stands out farther than leaves is relief too
  EXPECT_DOUBLE_EQ(relief[0].depth, 0.2);
}

TEST(FramedWindows, PanelsAndPlatesOfOtherSizesStay) {
  // Panels below windows are as wide and lower; plates elsewhere are in no row; a pillar before a wall is deeper.
  const std::vector<FoundRectangle> plates{rectangle({1, 1.8, -0.1, 0.9}, 0.05), rectangle({4.5, 5.3, 1.4, 3.2}, 0.05),
                                           rectangle({7, 7.8, 1, 2.8}, 0.5)};
  std::vector<FoundRectangle> relief = plates, openings{rectangle({1, 1.8, 1, 2.8})};
  EXPECT_TRUE(framed(relief, openings).empty());
  EXPECT_EQ(relief.size(), 3u);
  EXPECT_EQ(openings.size(), 1u);
}

}  // namespace
}  // namespace ilot
