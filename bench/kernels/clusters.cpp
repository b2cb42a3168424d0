// SPDX-License-Identifier: Apache-2.0
// Euclidean clusters of the houses of a town, 0.5 m. They are compared with the flood that libraries use, over
// nanoflann's tree. The partitions must be equal before any timing.
#include "kernels/neighbours/clusters.h"

#include "bench/compare.h"
#include "bench/town.h"

namespace {

using namespace ilot;

// Labels are numbered by first appearance, like ours.
std::vector<std::uint32_t> flood(const bench::PeerTree& peer, double radius) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  const Points& p = peer.adaptor.p;
  std::vector<std::uint32_t> id(p.size, kNone), stack;
  std::vector<std::pair<std::uint32_t, double>> matches;
  std::uint32_t count = 0;
  for (std::uint32_t seed = 0; seed < p.size; ++seed) {
    if (id[seed] != kNone) continue;
    stack.push_back(seed);
    id[seed] = count;
    while (!stack.empty()) {
      const std::uint32_t q = stack.back();
      stack.pop_back();
      const float at[3]{p.x[q], p.y[q], p.z[q]};
      peer.tree.radiusSearch(at, radius * radius + 0.5, matches, nanoflann::SearchParams(0, 0, false));
      for (const auto& [i, d2] : matches) {
        if (id[i] != kNone) continue;
        id[i] = count;
        stack.push_back(i);
      }
    }
    ++count;
  }
  return id;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::int64_t kRadius = 500;
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface houses = bench::make_houses(static_cast<std::size_t>(millions * 1e6));
    const auto all = bench::all_of(houses.size);
    const bench::PeerTree peer(houses.view());
    bench::require(euclidean_clusters(houses.view(), all, kRadius).id == flood(peer, kRadius),
                   "clusters: partition differs from the flood's");
    bench::compare({"clusters", "0.5 m, " + bench::in_millions(millions), 1, millions, "M points"},
                   {{"ilot", [&] { euclidean_clusters(houses.view(), all, kRadius); }}, {"flood, nanoflann", [&] {
                                                                                           const bench::PeerTree fresh(
                                                                                               houses.view());
                                                                                           flood(fresh, kRadius);
                                                                                         }}});
  }
}
