// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/hough_normals.h"
#include "kernels/core/quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels/neighbours/hough_normals_body.h"
#include "kernels/neighbours/knn.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/oriented_sets.h"

namespace ilot {
namespace {

std::vector<PackedNormal> run_hough(Points points, int k, std::int64_t max_d2 = kMaxSquaredReach) {
  std::vector<PackedNormal> out(points.size);
  std::vector<std::int64_t> reach2(points.size);
  hough_normals(build_neighbour_index(points), test::all_of(points.size), {.k = k, .max_d2 = max_d2}, out, reach2);
  return out;
}

std::vector<PackedNormal> run_pca(Points points, int k) {
  std::vector<PackedNormal> out(points.size);
  std::vector<std::int64_t> reach2(points.size);
  normals(build_neighbour_index(points), test::all_of(points.size), {k, kMaxSquaredReach}, out, reach2);
  return out;
}

double degrees_between(const PackedNormal& n, Vec3 truth) {
  const Vec3 v{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
  return std::acos(std::min(1.0, std::abs(dot(v, truth)) / norm(v))) * 180 / 3.141592653589793;
}

// A ridge seen from the air: two faces sloping 45 degrees, random points about `step` apart, 10 units of noise. Points
// carry the normal of their face.
constexpr double kStep = 288, kSide = 12000;
test::OrientedSet ridge() {
  test::OrientedSetBuilder builder(7);
  Rng rng(8);
  for (int i = 0; i < static_cast<int>(kSide * kSide / (kStep * kStep)); ++i) {
    const double x = rng.uniform() * kSide, y = rng.uniform() * kSide, from_ridge = x - kSide / 2;
    const double up = std::sqrt(0.5);
    builder.add({x, y, 20000 - std::abs(from_ridge) + 10 * test::bell(rng)}, {from_ridge > 0 ? up : -up, 0, up});
  }
  return builder.build();
}

TEST(HoughNormals, FlatGridPointsUp) {
  std::vector<Cell3> cells;
  for (std::uint32_t i = 0; i < 400; ++i) cells.push_back({i % 20 * 10, i / 20 * 10, 500});
  for (const PackedNormal& n : run_hough(test::make_set("flat", cells).view(), 30))
    EXPECT_EQ(n, (PackedNormal{0, 0, 32767, 0}));
}

// What the method is for: within one step of the edge, principal components are more than 20 degrees off and these
// less than 5; away from it both are within a degree or so.
TEST(HoughNormals, KeepEdgesWherePrincipalComponentsRoundThem) {
  const test::OrientedSet set = ridge();
  const auto hough = run_hough(set.view().points, 30), pca = run_pca(set.view().points, 30);
  std::vector<double> edge_hough, edge_pca, far_hough;
  std::size_t near_a_face = 0;
  for (std::size_t i = 0; i < set.size; ++i) {
    const double from_ridge = std::abs(set.position(i).x - kSide / 2);
    const double error = degrees_between(hough[i], set.normal(i));
    if (from_ridge > 4 * kStep) far_hough.push_back(error);
    if (from_ridge > kStep) continue;
    edge_hough.push_back(error);
    edge_pca.push_back(degrees_between(pca[i], set.normal(i)));
    const Vec3 n = set.normal(i);
    near_a_face += std::min(error, degrees_between(hough[i], {-n.x, n.y, n.z})) < 5;
  }
  EXPECT_LT(upper_median(edge_hough), 5);
  EXPECT_GT(upper_median(edge_pca), 20);
  EXPECT_LT(upper_median(far_hough), 1);
  EXPECT_GT(static_cast<double>(near_a_face), 0.9 * static_cast<double>(edge_hough.size()));
}

TEST(HoughNormals, DegenerateNeighbourhoodsHaveNone) {
  for (const PackedNormal& n : run_hough(test::point_sets(50)[3].view(), 8)) EXPECT_EQ(n, PackedNormal{});
  const auto pair = test::make_set("pair", {{0, 0, 0}, {1, 0, 0}});
  for (const PackedNormal& n : run_hough(pair.view(), 30)) EXPECT_EQ(n, PackedNormal{});
  const auto heap = test::make_set("heap", std::vector<Cell3>(100, Cell3{5, 5, 5}));
  for (const PackedNormal& n : run_hough(heap.view(), 30)) EXPECT_EQ(n, PackedNormal{});
}

// Three points have one triplet; five of which three are near take the short list.
TEST(HoughNormals, ShortListsAreAnswered) {
  const auto three = test::make_set("three", {{0, 0, 0}, {100, 0, 100}, {0, 100, 0}});
  const double h = std::sqrt(0.5);
  for (const PackedNormal& n : run_hough(three.view(), 30)) EXPECT_LT(degrees_between(n, {-h, 0, h}), 0.01);
  const auto five = test::make_set("five", {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {500, 500, 500}, {500, 900, 10}});
  const auto got = run_hough(five.view(), 5, 200);
  EXPECT_EQ(got[0], (PackedNormal{0, 0, 32767, 0}));
  EXPECT_EQ(got[3], PackedNormal{});
}

TEST(HoughNormals, AreTheSameBitsAfterAShift) {
  const auto set = test::point_sets(500)[1];
  auto moved = set;
  for (std::size_t i = 0; i < set.size; ++i) {
    moved.x[i] += 1 << 20;
    moved.y[i] -= 1 << 21;
    moved.z[i] += 12345;
  }
  EXPECT_EQ(run_hough(set.view(), 30), run_hough(moved.view(), 30));
}

// The draws are keyed by where neighbours lie, not by their order: any order of points gives the same normals, where no
// neighbour ties with another.
TEST(HoughNormals, DoNotDependOnTheOrderOfPoints) {
  const test::OrientedSet set = ridge();
  auto turned = set;
  for (auto* v : {&turned.x, &turned.y, &turned.z})
    std::reverse(v->begin(), v->begin() + static_cast<std::ptrdiff_t>(set.size));
  const auto forward = run_hough(set.view().points, 30), backward = run_hough(turned.view().points, 30);
  for (std::size_t i = 0; i < set.size; ++i) ASSERT_EQ(forward[i], backward[set.size - 1 - i]) << i;
}

TEST(HoughNormals, EveryInstructionSetGivesTheSameBits) {
  const auto isas = test::vector_isas();
  if (isas.empty()) GTEST_SKIP() << "this machine has the baseline alone";
  constexpr std::uint32_t n = 501, offsets[] = {1, 2, 1, 4, 2, 3, 1, 5};
  const float rotations[9 * simd::kHoughRotations] = {
      1, 0,      0, 0,     1, 0, 0, 0, 1,    0.6f,  0.8f, 0,    -0.8f, 0.6f, 0, 0, 0, 1, 0.28f, 0, 0.96f, 0, 1,
      0, -0.96f, 0, 0.28f, 1, 0, 0, 0, 0.6f, -0.8f, 0,    0.8f, 0.6f,  0,    1, 0, 0, 0, 1,     1, 0,     0};
  for (const auto& set : test::point_sets(n)) {
    const auto queries = test::all_of(n);
    for (const int k : {7, 16, 30, 64}) {
      std::vector<std::uint32_t> list(n * static_cast<std::size_t>(k));
      std::vector<std::int64_t> reach2(n);
      knn(build_neighbour_index(set.view()), queries, {k, kMaxSquaredReach}, list, reach2);
      std::vector<double> a(3 * n), b(3 * n);
      simd::HoughArgs args{set.x.data(), set.y.data(), set.z.data(), queries.data(), n, list.data(), k, offsets, 4,
                           rotations,    a.data()};
      simd::kHoughNormals.of(simd::Isa::baseline).hough_directions(args);
      for (const simd::Isa isa : isas) {
        args.out = b.data();
        simd::kHoughNormals.of(isa).hough_directions(args);
        EXPECT_EQ(a, b) << set.name << " k=" << k << " " << simd::name_of(isa);
      }
    }
  }
}

}  // namespace
}  // namespace ilot
