// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/eigen3.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

Symmetric3 random_covariance(Rng& rng, double flatness) {
  Eigen::Matrix3d a;
  for (int i = 0; i < 9; ++i) a(i / 3, i % 3) = rng.uniform() - 0.5;
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr(a);
  const Eigen::Matrix3d q = qr.householderQ();
  const Eigen::Vector3d values(flatness * rng.uniform(), 0.1 + rng.uniform(), 2 + rng.uniform());
  const Eigen::Matrix3d m = q * values.asDiagonal() * q.transpose();
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

Eigen::Matrix3d dense(const Symmetric3& m) {
  Eigen::Matrix3d d;
  d << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return d;
}

TEST(EigenSymmetric, AgreesWithEigen) {
  Rng rng(1);
  for (int i = 0; i < 2000; ++i) {
    const Symmetric3 m = random_covariance(rng, i % 2 == 0 ? 1e-9 : 0.09);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> want(dense(m));
    const Eigen3 got = eigen_symmetric(m);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(got.values[static_cast<std::size_t>(j)], want.eigenvalues()[j], 1e-14);
    const Vec3 v = got.vectors[0];
    EXPECT_LT(Eigen::Vector3d(v.x, v.y, v.z).cross(want.eigenvectors().col(0)).norm(), 1e-13);
    const SmallestEigen fast = smallest_eigen(m);
    ASSERT_TRUE(fast.unique);
    EXPECT_NEAR(fast.value, want.eigenvalues()[0], 2e-13);
    EXPECT_LT(Eigen::Vector3d(fast.vector.x, fast.vector.y, fast.vector.z).cross(want.eigenvectors().col(0)).norm(),
              1e-11);
  }
}

TEST(SmallestEigen, KnowsWhenThereIsNoDirection) {
  EXPECT_FALSE(smallest_eigen({}).unique);
  EXPECT_FALSE(smallest_eigen({1, 0, 0, 1, 0, 1}).unique);  // a ball
  EXPECT_FALSE(smallest_eigen({1, 1, 1, 1, 1, 1}).unique);  // a line
  EXPECT_TRUE(smallest_eigen({1, 0, 0, 1, 0, 0}).unique);
}

}  // namespace
}  // namespace ilot
