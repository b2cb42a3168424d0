// SPDX-License-Identifier: Apache-2.0
// Radius search in an airborne town beside nanoflann's, unsorted. The answers are compared as sets before any timing.
#include "kernels/neighbours/radius.h"

#include <algorithm>

#include "bench/compare.h"
#include "bench/town.h"

namespace {

using namespace ilot;
using Matches = std::vector<std::pair<std::uint32_t, double>>;

std::size_t theirs_at(const bench::PeerTree& peer, std::uint32_t query, double radius2, Matches& matches) {
  const Points& p = peer.adaptor.p;
  const float at[3]{p.x[query], p.y[query], p.z[query]};
  return peer.tree.radiusSearch(at, radius2, matches, nanoflann::SearchParams(0, 0, false));
}

void check(const NeighbourIndex& index, const bench::PeerTree& peer, std::span<const std::uint32_t> queries,
           std::int64_t radius2) {
  const RadiusNeighbours got = radius_search(index, queries, radius2);
  for (std::size_t q = 0; q < queries.size(); q += 97) {
    Matches matches;
    theirs_at(peer, queries[q], static_cast<double>(radius2) + 0.5, matches);  // theirs is open
    std::vector<std::uint32_t> want;
    for (const auto& [i, d2] : matches) want.push_back(i);
    std::sort(want.begin(), want.end());
    const auto begin = got.index.begin() + static_cast<std::ptrdiff_t>(got.begin[q]);
    const auto end = got.index.begin() + static_cast<std::ptrdiff_t>(got.begin[q + 1]);
    bench::require(std::equal(begin, end, want.begin(), want.end()), "radius: answers differ from nanoflann's");
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface surface = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const NeighbourIndex index = build_neighbour_index(surface.view());
    const bench::PeerTree peer(surface.view());
    std::vector<std::uint32_t> queries(std::min<std::size_t>(surface.size, 100000));
    std::iota(queries.begin(), queries.end(), static_cast<std::uint32_t>((surface.size - queries.size()) / 2));
    const auto ours = [&](std::int64_t radius2) {
      bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
        radius_search(index, std::span(queries).subspan(begin, end - begin), radius2);
      });
    };
    const auto theirs = [&](std::int64_t radius2) {
      bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
        Matches matches;
        for (std::size_t i = begin; i < end; ++i)
          theirs_at(peer, queries[i], static_cast<double>(radius2) + 0.5, matches);
      });
    };
    const double items = static_cast<double>(queries.size()) / 1e6;
    for (const std::int64_t radius : {500, 1000, 3000}) {  // millimetres; about 9, 38 and 340 points
      const std::string variant = std::to_string(radius) + " mm, " + bench::in_millions(millions);
      check(index, peer, queries, radius * radius);
      bench::compare({"radius", variant, 1, items, "M points"},
                     {{"ilot", [&] { ours(radius * radius); }}, {"nanoflann", [&] { theirs(radius * radius); }}});
    }
    bench::scaling({.kernel = "radius", .variant = "1000 mm"}, [&] { ours(1000 * 1000); });
  }
}
