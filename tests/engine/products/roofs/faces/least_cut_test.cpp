// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/least_cut.h"

#include <gtest/gtest.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/push_relabel_max_flow.hpp>

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

std::int64_t cost(const Gains& gain, const std::vector<CutArc>& arcs, const std::vector<std::uint8_t>& goes) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < gain.size(); ++i)
    if (goes[i] != 0) sum += gain[i];
  for (const CutArc& a : arcs)
    if (goes[a.from] == 0 && goes[a.to] != 0) sum += a.capacity;
  return sum;
}

// What Boost.Graph's push-relabel can send at most, which is what the least cut cuts: the two are equal.
std::int64_t flow_by_boost(const Gains& gain, const std::vector<CutArc>& arcs) {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Arc = boost::property<boost::edge_capacity_t, std::int64_t,
                              boost::property<boost::edge_residual_capacity_t, std::int64_t,
                                              boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>;
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Arc> graph(gain.size() + 2);
  const auto connect = [&](std::size_t from, std::size_t to, std::int64_t capacity) {
    const auto arc = boost::add_edge(from, to, graph).first, back = boost::add_edge(to, from, graph).first;
    boost::put(boost::edge_capacity, graph, arc, capacity);
    boost::put(boost::edge_capacity, graph, back, 0);
    boost::put(boost::edge_reverse, graph, arc, back);
    boost::put(boost::edge_reverse, graph, back, arc);
  };
  for (const CutArc& a : arcs) connect(a.from, a.to, a.capacity);
  for (std::size_t i = 0; i < gain.size(); ++i) {
    if (gain[i] > 0) connect(gain.size(), i, gain[i]);
    if (gain[i] < 0) connect(i, gain.size() + 1, -gain[i]);
  }
  return boost::push_relabel_max_flow(graph, gain.size(), gain.size() + 1);
}

// Networks like those of roofs: a grid of cells, capacities of many sizes, arcs one way or both.
TEST(LeastCut, CutsWhatTheGreatestFlowOfBoostIs) {
  Rng rng(11);
  for (int round = 0; round < 60; ++round) {
    const auto side = static_cast<std::uint32_t>(2 + rng.below(20)), n = side * side;
    Gains gain;
    std::int64_t all_who_would_go = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      gain.push_back((static_cast<std::int64_t>(rng.below(2001)) - 1000) << rng.below(20));
      all_who_would_go += std::min<std::int64_t>(0, gain.back());
    }
    std::vector<CutArc> arcs;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (i % side + 1 < side) arcs.push_back({i, i + 1, static_cast<std::int64_t>(rng.below(1000) << rng.below(20))});
      if (i + side < n) arcs.push_back({i + side, i, static_cast<std::int64_t>(rng.below(1000) << rng.below(20))});
      if (i + side < n) arcs.push_back({i, i + side, static_cast<std::int64_t>(rng.below(1000) << rng.below(20))});
    }
    const std::vector<std::uint8_t> goes = least_cut(gain, arcs);
    ASSERT_EQ(cost(gain, arcs, goes) - all_who_would_go, flow_by_boost(gain, arcs)) << "round " << round;
    for (std::uint32_t i = 0; i < n; ++i) {  // the smallest such set: nobody goes who could stay at no more cost
      if (goes[i] == 0) continue;
      std::vector<std::uint8_t> without = goes;
      without[i] = 0;
      ASSERT_GT(cost(gain, arcs, without), cost(gain, arcs, goes));
    }
  }
}

}  // namespace
}  // namespace ilot
