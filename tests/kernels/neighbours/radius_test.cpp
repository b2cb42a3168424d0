// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/radius.h"

#include <gtest/gtest.h>

#include <numeric>

#include "kernels/neighbours/knn.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/point_sets.h"

namespace ilot {
namespace {

RadiusNeighbours brute_radius(Points p, std::span<const std::uint32_t> queries, std::int64_t radius2) {
  RadiusNeighbours r{{0}, {}};
  for (const std::uint32_t q : queries) {
    for (std::uint32_t j = 0; j < p.size; ++j) {
      const double dx = p.x[q] - p.x[j], dy = p.y[q] - p.y[j], dz = p.z[q] - p.z[j];
      if (dx * dx + dy * dy + dz * dz <= static_cast<double>(radius2)) r.index.push_back(j);
    }
    r.begin.push_back(r.index.size());
  }
  return r;
}

TEST(RadiusSearch, IsClosed) {
  const auto set = test::make_set("three", {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  const NeighbourIndex index = build_neighbour_index(set.view());
  EXPECT_EQ(radius_search(index, test::all_of(1), 16).index, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(radius_search(index, test::all_of(1), 15).index, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(radius_search(index, test::all_of(1), 0).index, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(radius_search(index, {}, 0).begin, (std::vector<std::uint64_t>{0}));
}

// Radii from one point to all, so that groups overflow, and past what float32 holds exactly.
TEST(RadiusSearch, EqualsBruteForce) {
  for (const std::uint32_t n : {1u, 7u, 8u, 9u, 65u, 1500u}) {
    for (const auto& set : test::point_sets(n)) {
      const NeighbourIndex index = build_neighbour_index(set.view());
      auto queries = test::all_of(n);
      std::erase_if(queries, [](std::uint32_t q) { return q % 11 == 4; });
      for (const std::int64_t radius2 : {std::int64_t{0}, std::int64_t{90}, std::int64_t{40000}, std::int64_t{1} << 25,
                                         std::int64_t{500000} * 500000, kMaxSquaredReach}) {
        const RadiusNeighbours got = radius_search(index, queries, radius2);
        const RadiusNeighbours want = brute_radius(set.view(), queries, radius2);
        ASSERT_EQ(got.begin, want.begin) << set.name << " n=" << n << " r2=" << radius2;
        ASSERT_EQ(got.index, want.index) << set.name << " n=" << n << " r2=" << radius2;
      }
    }
  }
}

TEST(RadiusSearch, EveryInstructionSetGivesTheSameAnswer) {
  const auto tables = test::vector_tables();
  if (tables.empty()) GTEST_SKIP() << "this machine has the baseline alone";
  constexpr std::uint32_t n = 2000, room = n * 500;
  for (const auto& set : test::point_sets(n)) {
    const NeighbourIndex index = build_neighbour_index(set.view());
    std::vector<const float*> boxes;
    for (const auto& level : index.boxes) boxes.push_back(level.data());
    const auto queries = test::all_of(n);
    for (const std::int64_t radius2 : {std::int64_t{2000}, std::int64_t{1} << 24}) {
      std::vector<std::uint32_t> ca(n), cb(n), a(room), b(room);
      simd::RadiusArgs args{set.x.data(),   set.y.data(),
                            set.z.data(),   n,
                            boxes.data(),   static_cast<int>(boxes.size()),
                            queries.data(), n,
                            radius2,        ca.data(),
                            a.data(),       room};
      const std::uint32_t answered = simd::find_table("baseline")->radius_search(args);
      const auto found = std::accumulate(ca.begin(), ca.begin() + answered, std::ptrdiff_t{0});
      for (const simd::Table* table : tables) {
        args.counts = cb.data();
        args.neighbours = b.data();
        EXPECT_EQ(table->radius_search(args), answered) << set.name << " " << table->name;
        EXPECT_TRUE(std::equal(ca.begin(), ca.begin() + answered, cb.begin())) << set.name << " " << table->name;
        EXPECT_TRUE(std::equal(a.begin(), a.begin() + found, b.begin())) << set.name << " " << table->name;
      }
    }
  }
}

}  // namespace
}  // namespace ilot
