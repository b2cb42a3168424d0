// SPDX-License-Identifier: Apache-2.0
// Neighbours and normals of an airborne town, compared with nanoflann and Eigen on the same points in the same order.
// Before any timing, the k-th distances must be equal and the normals must agree within 1e-4 rad.
#include "kernels/neighbours/normals.h"

#include "bench/compare.h"
#include "bench/eigen_normals.h"
#include "kernels/neighbours/knn.h"

namespace {

using namespace ilot;

struct Town {
  explicit Town(std::size_t n) : surface(bench::make_surface(n)), index(build_neighbour_index(surface.view())) {}
  bench::Surface surface;
  NeighbourIndex index;
};

// A stretch in the middle of the town that is larger than the caches.
std::vector<std::uint32_t> stretch(std::size_t n) {
  std::vector<std::uint32_t> q(std::min<std::size_t>(n, 200000));
  std::iota(q.begin(), q.end(), static_cast<std::uint32_t>((n - q.size()) / 2));
  return q;
}

struct Normals {
  std::vector<PackedNormal> n;
  std::vector<std::int64_t> reach2;
};

void ours(const NeighbourIndex& index, std::span<const std::uint32_t> queries, int k, Normals& out) {
  out.n.resize(queries.size());
  out.reach2.resize(queries.size());
  bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
    normals(index, queries.subspan(begin, end - begin), {k, kMaxSquaredReach},
            std::span(out.n).subspan(begin, end - begin), std::span(out.reach2).subspan(begin, end - begin));
  });
}

void neighbours(const NeighbourIndex& index, std::span<const std::uint32_t> queries, int k,
                std::vector<std::uint32_t>& out, std::vector<std::int64_t>& reach2) {
  const auto stride = static_cast<std::size_t>(k);
  out.resize(queries.size() * stride);
  reach2.resize(queries.size());
  bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
    knn(index, queries.subspan(begin, end - begin), {k, kMaxSquaredReach},
        std::span(out).subspan(begin * stride, (end - begin) * stride), std::span(reach2).subspan(begin, end - begin));
  });
}

void theirs(const bench::PeerTree& peer, std::span<const std::uint32_t> queries, int k) {
  bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
    std::uint32_t index[kMaxNeighbours];
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += bench::peer_normal(peer, queries[i], static_cast<std::size_t>(k), index).n.z();
    bench::require(sum == sum, "normals: nanoflann + Eigen gave no number");
  });
}

void theirs_without_normals(const bench::PeerTree& peer, std::span<const std::uint32_t> queries, int k) {
  bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
    std::uint32_t index[kMaxNeighbours];
    double d2[kMaxNeighbours];
    const Points& p = peer.adaptor.p;
    for (std::size_t i = begin; i < end; ++i) {
      const float at[3]{p.x[queries[i]], p.y[queries[i]], p.z[queries[i]]};
      peer.tree.knnSearch(at, static_cast<std::size_t>(k), index, d2);
    }
  });
}

void check(const Town& town, const bench::PeerTree& peer, std::span<const std::uint32_t> queries, int k) {
  Normals got;
  ours(town.index, queries, k, got);
  std::uint32_t index[kMaxNeighbours];
  for (std::size_t i = 0; i < queries.size(); i += 97) {
    const bench::PeerNormal want = bench::peer_normal(peer, queries[i], static_cast<std::size_t>(k), index);
    const Eigen::Vector3d v = Eigen::Vector3d(got.n[i].x, got.n[i].y, got.n[i].z).normalized();
    bench::require(static_cast<std::int64_t>(want.reach2) == got.reach2[i] && v.cross(want.n).norm() <= 1e-4,
                   "normals: query " + std::to_string(queries[i]) + " differs from nanoflann + Eigen");
  }
}

void measure(const Town& town, const bench::PeerTree& peer, const std::string& size) {
  const auto queries = stretch(town.surface.size);
  const double items = static_cast<double>(queries.size()) / 1e6;
  for (const int k : {8, 16, 30}) {
    check(town, peer, queries, k);
    const std::string variant = "k=" + std::to_string(k) + ", " + size;
    Normals out;
    std::vector<std::uint32_t> lists;
    std::vector<std::int64_t> reach2;
    for (const int threads : {1, 2})
      bench::compare({"normals", variant, threads, items, "M points"},
                     {{"ilot", [&] { ours(town.index, queries, k, out); }},
                      {"nanoflann + Eigen", [&] { theirs(peer, queries, k); }}});
    bench::compare({"knn", variant, 1, items, "M points"},
                   {{"ilot", [&] { neighbours(town.index, queries, k, lists, reach2); }},
                    {"nanoflann", [&] { theirs_without_normals(peer, queries, k); }}});
  }
  Normals out;
  bench::scaling({.kernel = "normals", .variant = "k=16, " + size}, [&] { ours(town.index, queries, 16, out); });
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const Town town(static_cast<std::size_t>(millions * 1e6));
    const bench::PeerTree peer(town.surface.view());
    measure(town, peer, bench::in_millions(millions));
  }
}
