// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/knn_body.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "tests/support/instruction_sets.h"
#include "tests/support/point_sets.h"

namespace ilot {
namespace {

struct Answer {
  std::vector<std::uint32_t> neighbours;
  std::vector<std::int64_t> reach2;
};

Answer run_knn(Points points, std::span<const std::uint32_t> queries, const KnnParams& params) {
  const NeighbourIndex index = build_neighbour_index(points);
  Answer a{std::vector<std::uint32_t>(queries.size() * static_cast<std::size_t>(params.k)),
           std::vector<std::int64_t>(queries.size())};
  knn(index, queries, params, a.neighbours, a.reach2);
  return a;
}

std::int64_t squared(Points p, std::uint32_t i, std::uint32_t j) {
  const double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j], dz = p.z[i] - p.z[j];
  return static_cast<std::int64_t>(dx * dx + dy * dy + dz * dz);
}

Answer brute_knn(Points points, std::span<const std::uint32_t> queries, const KnnParams& params) {
  Answer a;
  for (const std::uint32_t q : queries) {
    std::vector<std::pair<std::int64_t, std::uint32_t>> all;
    for (std::uint32_t j = 0; j < points.size; ++j)
      if (squared(points, q, j) <= params.max_d2) all.emplace_back(squared(points, q, j), j);
    std::sort(all.begin(), all.end());
    const std::size_t k = static_cast<std::size_t>(params.k);
    std::vector<std::uint32_t> nearest;
    for (std::size_t i = 0; i < k; ++i) nearest.push_back(i < all.size() ? all[i].second : kNoNeighbour);
    std::sort(nearest.begin(), nearest.end());
    a.neighbours.insert(a.neighbours.end(), nearest.begin(), nearest.end());
    a.reach2.push_back(all.size() < k ? -1 : all[k - 1].first);
  }
  return a;
}

TEST(Knn, ThreePointsByHand) {
  const auto set = test::make_set("three", {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
  const std::uint32_t query[] = {0};
  const Answer a = run_knn(set.view(), query, {3, kMaxSquaredReach});
  EXPECT_EQ(a.neighbours, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(a.reach2[0], 16);
  const Answer near = run_knn(set.view(), query, {3, 9});
  EXPECT_EQ(near.neighbours, (std::vector<std::uint32_t>{0, 1, kNoNeighbour}));
  EXPECT_EQ(near.reach2[0], -1);
}

// The example of knn.h.
TEST(Knn, OneQuery) {
  const auto set = test::make_set("line", {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {6, 0, 0}});
  const NeighbourIndex index = build_neighbour_index(set.view());
  const std::uint32_t query = 2;
  std::array<std::uint32_t, 3> near{};
  std::int64_t reach2 = 0;
  knn(index, {&query, 1}, {.k = 3}, near, {&reach2, 1});
  EXPECT_EQ(near, (std::array<std::uint32_t, 3>{0, 1, 2}));  // 0 and 3 are equally far: the smaller index
  EXPECT_EQ(reach2, 9);
}

TEST(Knn, EqualsBruteForceOnEverySetSizeAndBound) {
  for (const std::uint32_t n : {1u, 7u, 8u, 9u, 64u, 65u, 700u}) {
    for (const auto& set : test::point_sets(n)) {
      const auto queries = test::all_of(n);
      for (const KnnParams params : {KnnParams{1, kMaxSquaredReach}, KnnParams{16, kMaxSquaredReach},
                                     KnnParams{30, 400}, KnnParams{64, 2500}, KnnParams{5, 0}}) {
        const Answer got = run_knn(set.view(), queries, params);
        const Answer want = brute_knn(set.view(), queries, params);
        EXPECT_EQ(got.neighbours, want.neighbours) << set.name << " n=" << n << " k=" << params.k;
        EXPECT_EQ(got.reach2, want.reach2) << set.name << " n=" << n << " k=" << params.k;
      }
    }
  }
}

TEST(Knn, ManyDuplicatesOverflowTheCandidateBuffer) {
  const auto set = test::make_set("duplicates", std::vector<Cell3>(100000, Cell3{5, 5, 5}));
  const std::uint32_t queries[] = {0, 50000, 99999};
  const Answer a = run_knn(set.view(), queries, {4, 100});
  const Answer b = brute_knn(set.view(), queries, {4, 100});
  EXPECT_EQ(a.neighbours, b.neighbours);
}

// Offsets reach 2^24 either way, so squared distances need 52 bits, more than a packed key has room for.
TEST(Knn, PointsAsFarApartAsOffsetsAllow) {
  constexpr float e = 8388608;  // 2^23
  const std::vector<std::array<float, 3>> corners{{-e, -e, -e}, {e, -e, -e}, {-e, e, -e}, {e, e, -e},
                                                  {-e, -e, e},  {e, -e, e},  {-e, e, e},  {e, e, e}};
  test::PointSet set;
  for (int i = 0; i < 5; ++i)
    for (const auto& c : corners) set.add(c[0] + static_cast<float>(i * 900), c[1] - static_cast<float>(i * 70), c[2]);
  set.pad();
  for (const KnnParams params :
       {KnnParams{2, kMaxSquaredReach}, KnnParams{5, kMaxSquaredReach}, KnnParams{6, kMaxSquaredReach}}) {
    const Answer got = run_knn(set.view(), test::all_of(set.size), params);
    const Answer want = brute_knn(set.view(), test::all_of(set.size), params);
    EXPECT_EQ(got.neighbours, want.neighbours) << params.k;
    EXPECT_EQ(got.reach2, want.reach2) << params.k;
  }
}

// Density falls and rises by a thousand from place to place, so that what one answer says of the next is wrong: guesses
// fail, boxes overflow, and the k-th neighbour may lie beyond what float32 holds exactly.
TEST(Knn, EqualsBruteForceWhereDensityJumps) {
  Rng rng(5);
  std::vector<Cell3> cells;
  for (std::uint32_t place = 0; place < 8; ++place) {
    const std::uint32_t wide = place % 2 == 0 ? 30 : 60000, home = place * 200000;
    for (int i = 0; i < (place % 2 == 0 ? 400 : 50); ++i)
      cells.push_back({home + static_cast<std::uint32_t>(rng.below(wide)), static_cast<std::uint32_t>(rng.below(wide)),
                       static_cast<std::uint32_t>(rng.below(30))});
  }
  const auto set = test::make_set("jumps", cells);
  for (const KnnParams params :
       {KnnParams{3, kMaxSquaredReach}, KnnParams{16, kMaxSquaredReach}, KnnParams{64, 40000}}) {
    const Answer got = run_knn(set.view(), test::all_of(set.size), params);
    const Answer want = brute_knn(set.view(), test::all_of(set.size), params);
    EXPECT_EQ(got.neighbours, want.neighbours) << params.k;
    EXPECT_EQ(got.reach2, want.reach2) << params.k;
  }
}

TEST(Knn, OrderOfQueriesDoesNotShow) {
  const auto set = test::point_sets(500)[1];
  auto queries = test::all_of(500);
  const Answer forward = run_knn(set.view(), queries, {8, kMaxSquaredReach});
  std::reverse(queries.begin(), queries.end());
  const Answer backward = run_knn(set.view(), queries, {8, kMaxSquaredReach});
  for (std::size_t q = 0; q < 500; ++q)
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_EQ(forward.neighbours[q * 8 + i], backward.neighbours[(499 - q) * 8 + i]);
}

TEST(Knn, EveryInstructionSetGivesTheSameBits) {
  const auto isas = test::vector_isas();
  if (isas.empty()) GTEST_SKIP() << "this machine has the baseline alone";
  for (const auto& set : test::point_sets(3000)) {
    const NeighbourIndex index = build_neighbour_index(set.view());
    std::vector<const float*> boxes;
    for (const auto& level : index.boxes) boxes.push_back(level.data());
    const auto queries = test::all_of(3000);
    std::vector<std::uint32_t> a(3000 * 12), b(3000 * 12);
    std::vector<std::int64_t> ra(3000), rb(3000);
    simd::KnnArgs args{set.x.data(),
                       set.y.data(),
                       set.z.data(),
                       3000,
                       boxes.data(),
                       static_cast<int>(boxes.size()),
                       queries.data(),
                       3000,
                       12,
                       kMaxSquaredReach,
                       a.data(),
                       ra.data()};
    simd::kKnn.of(simd::Isa::baseline).knn(args);
    args.neighbours = b.data();
    args.reach2 = rb.data();
    for (const simd::Isa isa : isas) {
      simd::kKnn.of(isa).knn(args);
      EXPECT_EQ(a, b) << set.name << " " << simd::name_of(isa);
      EXPECT_EQ(ra, rb) << set.name << " " << simd::name_of(isa);
    }
  }
}

}  // namespace
}  // namespace ilot
