// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/copc/copc_octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Key = std::tuple<int, std::uint32_t, std::uint32_t, std::uint32_t>;

Key key_of(const CopcNode& node) {
  return {node.level, node.cell.x, node.cell.y, node.cell.z};
}

Key parent_of(const CopcNode& node) {
  return {node.level - 1, node.cell.x / 2, node.cell.y / 2, node.cell.z / 2};
}

std::uint64_t random_code(Rng& rng, std::uint32_t reach) {
  const auto below = [&rng](std::uint64_t n) { return static_cast<std::uint32_t>(rng.below(n)); };
  const std::uint32_t x = below(reach), y = below(reach);
  return morton_code({x, y, below(64)});
}

std::vector<CopcPoint> numbered(const std::vector<std::uint64_t>& codes) {
  std::vector<CopcPoint> points;
  for (const std::uint64_t code : codes) points.push_back({code, static_cast<std::uint32_t>(points.size())});
  return points;
}

// Every point once, in the cube of its node, rows ascending; parents stand before children and hold points.
void check(const std::vector<std::uint64_t>& codes) {
  std::vector<CopcPoint> points = numbered(codes);
  const std::vector<CopcNode> nodes = build_copc_octree(points);
  std::set<Key> seen;
  std::vector<int> times(codes.size());
  for (const CopcNode& node : nodes) {
    ASSERT_TRUE(node.level == 0 || seen.count(parent_of(node)));
    ASSERT_TRUE(seen.insert(key_of(node)).second);
    ASSERT_LT(node.first, node.end);
    for (std::uint64_t i = node.first; i < node.end; ++i) {
      ASSERT_EQ(points[i].code, codes[points[i].row]);
      ASSERT_EQ(morton_cell(points[i].code >> 3 * (kMortonBits - node.level)), node.cell);
      ASSERT_TRUE(i == node.first || points[i - 1].row < points[i].row);
      ++times[points[i].row];
    }
  }
  EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
}

TEST(CopcOctree, NoPointsAreARootWithout) {
  std::vector<CopcPoint> none;
  const auto nodes = build_copc_octree(none);
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].first, nodes[0].end);
}

TEST(CopcOctree, FewPointsAreTheRoot) {
  std::vector<CopcPoint> points = numbered({7, 3, 1ull << 62});
  const auto nodes = build_copc_octree(points);
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(key_of(nodes[0]), Key(0, 0, 0, 0));
  EXPECT_EQ(nodes[0].end, 3u);
  EXPECT_EQ(points[0].row, 0u);
}

TEST(CopcOctree, TheRootKeepsThePointNearestToTheCentreOfEachCell) {
  Rng rng(4);
  std::vector<std::uint64_t> codes;
  for (int i = 0; i < 150000; ++i) codes.push_back(random_code(rng, 1u << kMortonBits));
  std::vector<CopcPoint> points = numbered(codes);
  const auto nodes = build_copc_octree(points);
  const auto distance = [](std::uint64_t code) {
    constexpr std::int64_t kSide = 1 << (kMortonBits - kCopcGridBits);
    const Cell3 c = morton_cell(code);
    std::int64_t sum = 0;
    for (const std::int64_t v : {c.x, c.y, c.z}) sum += (2 * (v % kSide) + 1 - kSide) * (2 * (v % kSide) + 1 - kSide);
    return sum;
  };
  const auto cell = [](std::uint64_t code) { return code >> 3 * (kMortonBits - kCopcGridBits); };
  std::vector<std::uint64_t> sorted = codes;
  std::sort(sorted.begin(), sorted.end());
  std::size_t cells = 0;
  for (std::uint64_t i = nodes[0].first; i < nodes[0].end; ++i) {
    for (auto it = std::lower_bound(sorted.begin(), sorted.end(), cell(points[i].code) << 42);
         it != sorted.end() && cell(*it) == cell(points[i].code); ++it)
      ASSERT_LE(distance(points[i].code), distance(*it));
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) cells += i == 0 || cell(sorted[i]) != cell(sorted[i - 1]);
  EXPECT_EQ(nodes[0].end - nodes[0].first, cells) << "one of each";
}

TEST(CopcOctree, InvariantsHoldForUniformClusteredAndCoincidentPoints) {
  Rng rng(1);
  std::vector<std::uint64_t> spread, clustered, mixed;
  for (int i = 0; i < 300000; ++i) {
    spread.push_back(random_code(rng, 1u << kMortonBits));
    clustered.push_back(random_code(rng, 300));
    mixed.push_back(i % 2 ? 12345678901234567ull : random_code(rng, 1u << (1 + rng.below(20))));
  }
  check(spread);
  check(clustered);
  check(mixed);
  check(std::vector<std::uint64_t>(100000, (std::uint64_t{1} << 63) - 1));
}

TEST(CopcOctree, NodesDependOnTheSetOfPointsOnly) {
  Rng rng(2);
  std::vector<std::uint64_t> codes;
  for (int i = 0; i < 100000; ++i) codes.push_back(random_code(rng, 5000));
  const auto shape = [](const std::vector<std::uint64_t>& of) {
    std::vector<CopcPoint> points = numbered(of);
    std::vector<std::pair<Key, std::multiset<std::uint64_t>>> result;
    for (const CopcNode& node : build_copc_octree(points)) {
      result.push_back({key_of(node), {}});
      for (std::uint64_t i = node.first; i < node.end; ++i) result.back().second.insert(points[i].code);
    }
    return result;
  };
  const auto forward = shape(codes);
  EXPECT_GT(forward.size(), 1u);
  std::reverse(codes.begin(), codes.end());
  EXPECT_EQ(shape(codes), forward);
}

}  // namespace
}  // namespace ilot
