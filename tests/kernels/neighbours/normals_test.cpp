// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/normals.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numeric>

#include "kernels/neighbours/knn.h"
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
