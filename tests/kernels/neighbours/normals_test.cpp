// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/normals.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals_body.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/point_sets.h"

namespace ilot {
namespace {

std::vector<PackedNormal> run_normals(Points points, int k, std::int64_t max_d2) {
  std::vector<std::uint32_t> queries(points.size);
  std::iota(queries.begin(), queries.end(), 0u);
  std::vector<PackedNormal> out(points.size);
  std::vector<std::int64_t> reach2(points.size);
  normals(build_neighbour_index(points), queries, {k, max_d2}, out, reach2);
  return out;
}

TEST(Normals, FlatGridPointsUp) {
  std::vector<Cell3> cells;
  for (std::uint32_t i = 0; i < 400; ++i) cells.push_back({i % 20 * 10, i / 20 * 10, 500});
  for (const PackedNormal& n : run_normals(test::make_set("flat", cells).view(), 16, kMaxSquaredReach))
    EXPECT_EQ(n, (PackedNormal{0, 0, 32767, 0}));
}

TEST(Normals, LinesPairsAndLonelyPointsHaveNone) {
  const auto line = test::point_sets(50)[3];
  for (const PackedNormal& n : run_normals(line.view(), 8, kMaxSquaredReach)) EXPECT_EQ(n, PackedNormal{});
  const auto pair = test::make_set("pair", {{0, 0, 0}, {1, 0, 0}});
  for (const PackedNormal& n : run_normals(pair.view(), 8, kMaxSquaredReach)) EXPECT_EQ(n, PackedNormal{});
  const auto sparse = test::make_set("sparse", {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}});
  for (const PackedNormal& n : run_normals(sparse.view(), 3, 99)) EXPECT_EQ(n, PackedNormal{});
}

// Oracle: Eigen's solver in double on the same neighbours.
TEST(Normals, AgreeWithEigenWithinTheRoundingOfThePacking) {
  const int k = 16;
  for (const auto& set : test::point_sets(600)) {
    if (set.name == "line" || set.name == "duplicates" || set.name == "grid") continue;
    const Points p = set.view();
    const auto got = run_normals(p, k, kMaxSquaredReach);
    const NeighbourIndex index = build_neighbour_index(p);
    for (std::uint32_t q = 0; q < p.size; ++q) {
      std::vector<std::uint32_t> list(k);
      std::vector<std::int64_t> reach2(1);
      knn(index, std::span(&q, 1), {k, kMaxSquaredReach}, list, reach2);
      Eigen::Matrix<double, 3, k> m;
      for (int i = 0; i < k; ++i) m.col(i) << p.x[list[i]], p.y[list[i]], p.z[list[i]];
      m.colwise() -= m.rowwise().mean().eval();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m * m.transpose());
      // A direction is only as certain as its eigenvalue is apart from the next.
      if (solver.eigenvalues()[1] - solver.eigenvalues()[0] < 1e-3 * solver.eigenvalues()[2]) continue;
      Eigen::Vector3d n(got[q].x, got[q].y, got[q].z);
      EXPECT_NEAR(n.norm(), 32767, 1.0);
      EXPECT_LT(n.normalized().cross(solver.eigenvectors().col(0)).norm(), 6e-5) << set.name << " " << q;
      const double curvature = solver.eigenvalues()[0] / solver.eigenvalues().sum();
      EXPECT_NEAR(got[q].curvature / 65535.0 / 3, curvature, 1e-5);
    }
  }
}

// Vector bodies handle near neighbours, plain code the others; a power of two moves every set from one to the other.
TEST(Normals, AreTheSameBitsAtAnyScale) {
  for (const auto& set : test::point_sets(700)) {
    auto wide = set;
    for (auto* v : {&wide.x, &wide.y, &wide.z})
      for (float& c : *v) c *= set.name == "clusters" ? 8 : 256;
    for (const int k : {3, 8, 13, 16, 30})
      EXPECT_EQ(run_normals(set.view(), k, kMaxSquaredReach), run_normals(wide.view(), k, kMaxSquaredReach))
          << set.name << " " << k;
  }
}

TEST(Normals, EveryInstructionSetGivesTheSameBits) {
  const auto isas = test::vector_isas();
  if (isas.empty()) GTEST_SKIP() << "this machine has the baseline alone";
  constexpr std::uint32_t n = 1001;
  for (const auto& set : test::point_sets(n)) {
    std::vector<std::uint32_t> queries(n);
    std::iota(queries.begin(), queries.end(), 0u);
    for (const int k : {3, 16, 21, 64}) {
      std::vector<std::uint32_t> list(n * static_cast<std::size_t>(k));
      std::vector<std::int64_t> reach2(n);
      knn(build_neighbour_index(set.view()), queries, {k, kMaxSquaredReach}, list, reach2);
      if (*std::max_element(reach2.begin(), reach2.end()) >= 1 << 24) continue;
      std::vector<PackedNormal> a(n), b(n);
      simd::NormalArgs args{set.x.data(), set.y.data(), set.z.data(), queries.data(), n, list.data(), k, &a[0].x};
      simd::kNormals.of(simd::Isa::baseline).neighbour_normals(args);
      for (const simd::Isa isa : isas) {
        args.out = &b[0].x;
        simd::kNormals.of(isa).neighbour_normals(args);
        EXPECT_EQ(a, b) << set.name << " " << simd::name_of(isa);
      }
    }
  }
}

TEST(Normals, AreTheSameBitsAfterAShift) {
  const auto set = test::point_sets(500)[1];
  auto moved = set;
  for (std::size_t i = 0; i < set.size; ++i) {
    moved.x[i] += 1 << 20;
    moved.y[i] -= 1 << 21;
    moved.z[i] += 12345;
  }
  EXPECT_EQ(run_normals(set.view(), 16, kMaxSquaredReach), run_normals(moved.view(), 16, kMaxSquaredReach));
}

}  // namespace
}  // namespace ilot
