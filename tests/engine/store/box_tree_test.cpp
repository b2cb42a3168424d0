// SPDX-License-Identifier: Apache-2.0
#include "engine/store/box_tree.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

IndexBox random_box(Rng& rng, std::int64_t reach, std::int64_t size) {
  const auto below = [&](std::int64_t n) {
    return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(n)));
  };
  const Index3 low{below(reach), below(reach), below(reach)};
  return {low, {low.x + below(size), low.y + below(size), low.z + below(size)}};
}

TEST(BoxTree, FindsWhatALoopFinds) {
  Rng rng(3);
  for (const std::size_t n : {0u, 1u, 7u, 8u, 9u, 64u, 65u, 513u, 5000u}) {
    std::vector<IndexBox> boxes;
    for (std::size_t i = 0; i < n; ++i) boxes.push_back(random_box(rng, 1000, 60));
    const BoxTree tree(boxes);
    for (int q = 0; q < 50; ++q) {
      const IndexBox box = random_box(rng, 1000, q < 25 ? 80 : 900);
      std::vector<std::uint32_t> expected, found;
      for (std::uint32_t i = 0; i < n; ++i)
        if (boxes[i].intersects(box)) expected.push_back(i);
      tree.find(boxes, box, found);
      EXPECT_EQ(found, expected) << n;
    }
  }
}

TEST(BoxTree, ABoxThatOnlyTouchesIsFound) {
  std::vector<IndexBox> boxes;
  for (std::int64_t i = 0; i < 100; ++i) boxes.push_back({{10 * i, 0, 0}, {10 * i + 4, 9, 9}});
  std::vector<std::uint32_t> found;
  BoxTree(boxes).find(boxes, {{504, 9, 9}, {510, 20, 20}}, found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{50, 51}));
}

}  // namespace
}  // namespace ilot
