// SPDX-License-Identifier: Apache-2.0
// Exact integer sums of points that are selected by index, compared with the same sums in double with Eigen. The
// covariances must agree to 1e-9 of their trace before any timing.
#include "kernels/core/moments.h"

#include <Eigen/Core>
#include <cmath>

#include "bench/compare.h"
#include "bench/town.h"

namespace {

using namespace ilot;

Eigen::Matrix3d eigen_covariance(Points p, std::span<const std::uint32_t> indices) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : indices) {
    const Eigen::Vector3d v(p.x[i], p.y[i], p.z[i]);
    mean += v;
    m += v * v.transpose();
  }
  mean /= static_cast<double>(indices.size());
  return m / static_cast<double>(indices.size()) - mean * mean.transpose();
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {0.4})) {
    const bench::Surface surface = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const Points p = surface.view();
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < p.size; ++i)
      if (i % 4 != 2) indices.push_back(i);
    bench::require(indices.size() < (1u << 19), "moments: at most 0.69 million points");
    const Symmetric3 ours = covariance(moments_of(p, indices));
    const Eigen::Matrix3d theirs = eigen_covariance(p, indices);
    bench::require(std::abs(ours.xx - theirs(0, 0)) + std::abs(ours.yz - theirs(1, 2)) < 1e-9 * theirs.trace(),
                   "moments: covariance differs from Eigen's");
    double sink = 0;
    bench::compare({"moments", bench::in_millions(millions), 1, static_cast<double>(indices.size()) / 1e6, "M points"},
                   {{"ilot", [&] { sink += covariance(moments_of(p, indices)).xx; }},
                    {"Eigen, double", [&] { sink += eigen_covariance(p, indices)(0, 0); }}});
    bench::require(sink > 0, "moments: nothing was computed");
  }
}
