// SPDX-License-Identifier: Apache-2.0
// Normals in the usual way with nanoflann and Eigen: search, covariance in double, Eigen's direct 3 x 3 solver.
#pragma once
#include <Eigen/Eigenvalues>

#include "bench/town.h"

namespace ilot::bench {

struct PeerNormal {
  Eigen::Vector3d n;
  double reach2 = 0;
};

inline PeerNormal peer_normal(const PeerTree& peer, std::uint32_t query, std::size_t k, std::uint32_t* index) {
  constexpr std::size_t kMost = 64;
  double d2[kMost];
  const Points& p = peer.adaptor.p;
  const float at[3]{p.x[query], p.y[query], p.z[query]};
  peer.tree.knnSearch(at, k, index, d2);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < k; ++i) {
    const Eigen::Vector3d v(p.x[index[i]] - at[0], p.y[index[i]] - at[1], p.z[index[i]] - at[2]);
    mean += v;
    m += v * v.transpose();
  }
  mean /= static_cast<double>(k);
  m = m / static_cast<double>(k) - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(m);
  return {solver.eigenvectors().col(0), d2[k - 1]};
}

}  // namespace ilot::bench
