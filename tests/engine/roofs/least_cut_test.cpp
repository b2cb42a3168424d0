// SPDX-License-Identifier: Apache-2.0
#include "engine/roofs/least_cut.h"

#include <gtest/gtest.h>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Gains = std::vector<std::int64_t>;

std::int64_t cost(const Gains& gain, const std::vector<CutArc>& arcs, std::uint32_t goes) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < gain.size(); ++i)
    if (goes >> i & 1) sum += gain[i];
  for (const CutArc& a : arcs)
    if (!(goes >> a.from & 1) && (goes >> a.to & 1)) sum += a.capacity;
  return sum;
}

TEST(LeastCut, EveryoneGoesWhereItPays) {
  EXPECT_EQ(least_cut(Gains{-3, 2, -1}, {}), (std::vector<std::uint8_t>{1, 0, 1}));
}

TEST(LeastCut, AStrongArcKeepsNeighboursTogether) {
  // The second would go, but the arc from the first costs more than it gains.
  const std::vector<CutArc> arcs{{0, 1, 5}};
  EXPECT_EQ(least_cut(Gains{4, -3}, arcs), (std::vector<std::uint8_t>{0, 0}));
}

TEST(LeastCut, StaysWhereNothingIsGained) {
  EXPECT_EQ(least_cut(Gains{0, 0}, {}), (std::vector<std::uint8_t>{0, 0}));
  EXPECT_TRUE(least_cut(Gains{}, {}).empty());
}

// The least of all sets, and of those the one inside all others.
TEST(LeastCut, AgreesWithTryingAllSets) {
  Rng rng(7);
  for (int round = 0; round < 300; ++round) {
    const auto n = static_cast<std::uint32_t>(1 + rng.below(8));
    Gains gain;
    for (std::uint32_t i = 0; i < n; ++i) gain.push_back(static_cast<std::int64_t>(rng.below(21)) - 10);
    std::vector<CutArc> arcs;
    for (std::uint64_t i = rng.below(15); i-- > 0;) {
      const auto a = static_cast<std::uint32_t>(rng.below(n)), b = static_cast<std::uint32_t>(rng.below(n));
      if (a != b) arcs.push_back({a, b, static_cast<std::int64_t>(rng.below(8))});
    }
    std::int64_t least = 0;
    for (std::uint32_t set = 0; set < 1u << n; ++set) least = std::min(least, cost(gain, arcs, set));
    std::uint32_t inside_all = (1u << n) - 1;
    for (std::uint32_t set = 0; set < 1u << n; ++set)
      if (cost(gain, arcs, set) == least) inside_all &= set;
    std::uint32_t found = 0;
    const std::vector<std::uint8_t> goes = least_cut(gain, arcs);
    for (std::uint32_t i = 0; i < n; ++i) found |= static_cast<std::uint32_t>(goes[i]) << i;
    ASSERT_EQ(found, inside_all) << "round " << round;
  }
}

}  // namespace
}  // namespace ilot
