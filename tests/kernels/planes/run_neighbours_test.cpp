// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/run_neighbours.h"

#include <set>

#include "kernels/neighbours/knn.h"
#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

constexpr std::uint32_t kRun = RunNeighbours::kRun;

test::OrientedSet walked_floor(int columns, int rows) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 100}, {1, 0, 0}, {0, 1, 0}, columns, rows, 10, 0});
  return b.build();
}

TEST(RunNeighbours, AreTheRunsOfAllListedPoints) {
  for (const int rows : {1, 3, 40}) {
    const auto set = walked_floor(33, rows);
    const auto near = test::neighbours_of(set.view().points, 9);
    const RunNeighbours runs(set.size, near.lists());
    ASSERT_EQ(runs.count(), (set.size + kRun - 1) / kRun);
    for (std::uint32_t r = 0; r < runs.count(); ++r) {
      std::set<std::uint32_t> wanted;
      for (std::uint32_t i = r * kRun; i < std::min<std::size_t>(set.size, (r + 1) * kRun); ++i)
        for (const std::uint32_t j : near.lists().of(i))
          if (j != kNoNeighbour && j / kRun != r) wanted.insert(j / kRun);
      const auto around = runs.around(r);
      EXPECT_EQ(std::set<std::uint32_t>(around.begin(), around.end()), wanted);
      EXPECT_EQ(around.size(), wanted.size()) << "each once";
    }
  }
}

// One point of another label, or of the set: its run is not quiet, nor is any that it lies around; all others are.
TEST(RunNeighbours, OnePointDisturbsItsSurroundings) {
  const auto set = walked_floor(40, 40);
  const auto near = test::neighbours_of(set.view().points, 9);
  const RunNeighbours runs(set.size, near.lists());
  std::vector<std::uint32_t> label(set.size, 3);
  const std::vector<std::uint8_t> all(runs.count(), 1);
  EXPECT_EQ(uniform_runs(runs, label), all);
  EXPECT_EQ(unaffected_runs(runs, {}), all);
  const std::vector<std::uint32_t> odd{700};
  label[700] = 0;
  std::vector<std::uint8_t> wanted = all;
  for (std::uint32_t r = 0; r < runs.count(); ++r)
    for (const std::uint32_t other : runs.around(r))
      if (other == 700 / kRun) wanted[r] = 0;
  wanted[700 / kRun] = 0;
  ASSERT_GT(std::count(wanted.begin(), wanted.end(), 1), 10);
  EXPECT_EQ(uniform_runs(runs, label), wanted);
  EXPECT_EQ(unaffected_runs(runs, odd), wanted);
}

}  // namespace
}  // namespace ilot
