// SPDX-License-Identifier: Apache-2.0
// kNN and PCA normals of an airborne town, beside nanoflann and Eigen on the same points in the same order. Before any
// timing the neighbours' distances must be equal and the normals within 1e-4 rad.
#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>
#include <cstdio>
#include <cstdlib>
#include <nanoflann.hpp>
#include <numeric>

#include "bench/surface.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals.h"

namespace {

using namespace ilot;

constexpr std::size_t kPoints = 1000000;
constexpr std::size_t kQueries = 200000;

const bench::Surface& surface() {
  static const bench::Surface s = bench::make_surface(kPoints);
  return s;
}

const std::vector<std::uint32_t>& queries() {
  static const std::vector<std::uint32_t> q = [] {
    std::vector<std::uint32_t> v(kQueries);
    std::iota(v.begin(), v.end(), 400000u);
    return v;
  }();
  return q;
}

struct Adaptor {
  const Points p = surface().view();
  std::size_t kdtree_get_point_count() const { return p.size; }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return axis == 0 ? p.x[i] : axis == 1 ? p.y[i] : p.z[i];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Adaptor, double>, Adaptor, 3,
                                                 std::uint32_t>;

struct Peer {
  Adaptor adaptor;
  Tree tree{3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10)};
};
const Peer& peer() {
  static const Peer p;
  return p;
}

Eigen::Vector3d peer_normal(std::uint32_t q, std::size_t k, double& reach2) {
  std::uint32_t index[kMaxNeighbours];
  double d2[kMaxNeighbours];
  const Points p = surface().view();
  const float at[3]{p.x[q], p.y[q], p.z[q]};
  peer().tree.knnSearch(at, k, index, d2);
  reach2 = d2[k - 1];
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
  return solver.eigenvectors().col(0);
}

void check(int k) {
  std::vector<PackedNormal> ours(kQueries);
  std::vector<std::int64_t> reach2(kQueries);
  normals(build_neighbour_index(surface().view()), queries(), {k, kMaxSquaredReach}, ours, reach2);
  for (std::size_t i = 0; i < kQueries; i += 97) {
    double theirs = 0;
    const Eigen::Vector3d n = peer_normal(queries()[i], static_cast<std::size_t>(k), theirs);
    const Eigen::Vector3d v = Eigen::Vector3d(ours[i].x, ours[i].y, ours[i].z).normalized();
    if (static_cast<std::int64_t>(theirs) != reach2[i] || v.cross(n).norm() > 1e-4) {
      std::fprintf(stderr, "normals: query %zu differs from nanoflann + Eigen\n", i);
      std::exit(1);
    }
  }
}

void BM_ilot(benchmark::State& state) {
  const int k = static_cast<int>(state.range(0));
  check(k);
  const NeighbourIndex index = build_neighbour_index(surface().view());
  std::vector<PackedNormal> out(kQueries);
  std::vector<std::int64_t> reach2(kQueries);
  for (auto _ : state) normals(index, queries(), {k, kMaxSquaredReach}, out, reach2);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kQueries));
}
BENCHMARK(BM_ilot)->Arg(8)->Arg(16)->Arg(30)->UseRealTime()->Unit(benchmark::kMillisecond);

void BM_ilot_knn_only(benchmark::State& state) {
  const int k = static_cast<int>(state.range(0));
  const NeighbourIndex index = build_neighbour_index(surface().view());
  std::vector<std::uint32_t> out(kQueries * static_cast<std::size_t>(k));
  std::vector<std::int64_t> reach2(kQueries);
  for (auto _ : state) knn(index, queries(), {k, kMaxSquaredReach}, out, reach2);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kQueries));
}
BENCHMARK(BM_ilot_knn_only)->Arg(8)->Arg(16)->Arg(30)->UseRealTime()->Unit(benchmark::kMillisecond);

void BM_nanoflann_eigen(benchmark::State& state) {
  const auto k = static_cast<std::size_t>(state.range(0));
  peer();
  for (auto _ : state) {
    double reach2 = 0;
    for (const std::uint32_t q : queries()) benchmark::DoNotOptimize(peer_normal(q, k, reach2));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kQueries));
}
BENCHMARK(BM_nanoflann_eigen)->Arg(8)->Arg(16)->Arg(30)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
