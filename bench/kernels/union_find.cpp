// SPDX-License-Identifier: Apache-2.0
// Joins the neighbours of a shuffled grid, compared with Boost's disjoint sets (union by rank, full path compression).
// The number of sets must be equal before any timing.
#include "kernels/core/union_find.h"

#include <boost/pending/disjoint_sets.hpp>
#include <vector>

#include "bench/compare.h"
#include "kernels/core/rng.h"

namespace {

using namespace ilot;
using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Returns seven of eight edges of a grid of side x side, in random order.
Edges grid_edges(std::uint32_t side) {
  Edges edges;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    if (i % side + 1 < side) edges.emplace_back(i, i + 1);
    if (i + side < side * side) edges.emplace_back(i, i + side);
  }
  Rng rng(9);
  for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[rng.below(i)]);
  edges.resize(edges.size() / 8 * 7);
  return edges;
}

std::size_t ours(std::size_t n, const Edges& edges) {
  std::vector<std::uint32_t> parents(n);
  UnionFind sets(parents);
  std::size_t count = n;
  for (const auto& [a, b] : edges) count -= sets.unite(a, b);
  return count;
}

std::size_t theirs(std::size_t n, const Edges& edges) {
  std::vector<std::uint32_t> parents(n);
  std::vector<std::uint8_t> ranks(n);
  boost::disjoint_sets<std::uint8_t*, std::uint32_t*> sets(ranks.data(), parents.data());
  for (std::uint32_t i = 0; i < n; ++i) sets.make_set(i);
  std::size_t count = n;
  for (const auto& [a, b] : edges) {
    const std::uint32_t u = sets.find_set(a), v = sets.find_set(b);
    if (u == v) continue;
    sets.link(u, v);
    --count;
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    std::uint32_t side = 1;
    while (1e-6 * side * side < millions) ++side;
    const std::size_t n = std::size_t{side} * side;
    const Edges edges = grid_edges(side);
    bench::require(ours(n, edges) == theirs(n, edges), "union_find: number of sets differs from Boost's");
    bench::compare({"union_find", bench::in_millions(millions), 1, static_cast<double>(edges.size()) / 1e6, "M edges"},
                   {{"ilot", [&] { ours(n, edges); }}, {"Boost disjoint_sets", [&] { theirs(n, edges); }}});
  }
}
