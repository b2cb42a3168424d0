// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/clusters_pass.h"

#include <algorithm>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/store/view.h"
#include "kernels/core/union_find.h"
#include "kernels/neighbours/clusters.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 64;
constexpr std::int64_t kFar = std::int64_t{1} << 52;

IndexBox column_around(const Block& block, std::int64_t by) {
  IndexBox box = block.box.grown(by);
  box.min.z = -kFar;
  box.max.z = kFar;
  return box;
}

// Clusters of the chosen points of a view, heights left out.
Clusters in_plan(View& view, std::span<const std::uint32_t> chosen, std::int64_t radius) {
  std::fill(view.z.begin(), view.z.end(), 0.0f);
  return euclidean_clusters(view.points(), chosen, radius);
}

void add(CloudCluster& cluster, Index3 p) {
  if (cluster.points++ == 0) {
    cluster.first = p;
    cluster.box = {p, p};
  }
  IndexBox& b = cluster.box;
  b.min = {std::min(b.min.x, p.x), std::min(b.min.y, p.y), std::min(b.min.z, p.z)};
  b.max = {std::max(b.max.x, p.x), std::max(b.max.y, p.y), std::max(b.max.z, p.z)};
}

void add(CloudCluster& sum, const CloudCluster& part) {
  const IndexBox &a = sum.box, &b = part.box;
  sum.box = {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
             {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
  sum.points += part.points;
}

// Clusters of one block's own points, numbered by their first points; column "cluster_part".
std::vector<CloudCluster> parts_of_block(const Store& store, std::uint32_t block, const ClusterParams& params) {
  const Block& b = store.blocks()[block];
  View view;
  view.anchor = b.node.min_corner();
  view.slices.push_back({block, 0, b.points, 0});
  view.size = b.points;
  load_points(store, view);
  const auto roles = store.read(block, columns::kRole);
  std::vector<std::uint32_t> chosen, part(b.points, 0);
  for (std::uint32_t i = 0; i < b.points; ++i)
    if (roles[i] == params.role) chosen.push_back(i);
  std::vector<Index3> positions;
  for (const std::uint32_t i : chosen) positions.push_back(view.position(i));
  const Clusters found = in_plan(view, chosen, params.radius);
  std::vector<CloudCluster> clusters(found.count);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    add(clusters[found.id[i]], positions[i]);
    part[chosen[i]] = found.id[i] + 1;
  }
  store.write(block, columns::kClusterPart, part);
  return clusters;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Parts of different blocks that hang together around this one. `first`: per block the number of its first part.
std::vector<Pair> links_of_block(const Store& store, std::uint32_t block, const ClusterParams& params,
                                 const std::vector<std::uint32_t>& first) {
  const IndexBox box = column_around(store.blocks()[block], params.radius);
  if (store.blocks_in(box).size() < 2) return {};
  View view = load_view(store, box, store.blocks()[block].node.min_corner());
  std::vector<std::uint32_t> chosen, part_of_chosen;
  for (const Slice& s : view.slices) {
    const auto parts = store.read(s.block, columns::kClusterPart, s.first, s.count);
    for (std::uint32_t i = 0; i < s.count; ++i) {
      if (parts[i] == 0) continue;
      chosen.push_back(s.at + i);
      part_of_chosen.push_back(first[s.block] + parts[i] - 1);
    }
  }
  const Clusters found = in_plan(view, chosen, params.radius);
  std::vector<std::uint32_t> first_part(found.count, UINT32_MAX);
  std::vector<Pair> links;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    std::uint32_t& leader = first_part[found.id[i]];
    if (leader == UINT32_MAX) leader = part_of_chosen[i];
    const Pair link{leader, part_of_chosen[i]};
    if (link.first != link.second && (links.empty() || links.back() != link)) links.push_back(link);
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

template <class Body>
void for_each_block(const Store& store, const PassContext& context, std::int64_t halo, const Body& body) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) {
    const std::uint64_t points = halo == 0 ? b.points : plan_view(store, column_around(b, halo), {}).size;
    tasks.push_back({points * kBytesPerPoint, b.points});
  }
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) { body(static_cast<std::uint32_t>(i)); });
}

}  // namespace

std::vector<CloudCluster> clusters_pass(const Store& store, const ClusterParams& params, const PassContext& context) {
  const std::size_t blocks = store.blocks().size();
  std::vector<std::vector<CloudCluster>> parts(blocks);
  for_each_block(store, context, 0, [&](std::uint32_t b) { parts[b] = parts_of_block(store, b, params); });
  std::vector<std::uint32_t> first(blocks);
  std::uint32_t count = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    first[b] = count;
    count += static_cast<std::uint32_t>(parts[b].size());
  }
  std::vector<std::vector<Pair>> links(blocks);
  for_each_block(store, context, params.radius,
                 [&](std::uint32_t b) { links[b] = links_of_block(store, b, params, first); });

  std::vector<std::uint32_t> parents(count), number(count);
  UnionFind sets(parents);
  for (const auto& of_block : links)
    for (const auto& [a, b] : of_block) sets.unite(a, b);
  std::vector<CloudCluster> clusters;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::uint32_t n = 0; n < parts[b].size(); ++n) {
      const std::uint32_t part = first[b] + n, root = sets.find(part);
      if (root == part) {
        number[part] = static_cast<std::uint32_t>(clusters.size());
        clusters.push_back(parts[b][n]);
      } else {
        number[part] = number[root];
        add(clusters[number[root]], parts[b][n]);
      }
    }
  }
  for_each_block(store, context, 0, [&](std::uint32_t b) {
    auto column = store.read(b, columns::kClusterPart);
    for (std::uint32_t& c : column) c = c == 0 ? 0 : number[first[b] + c - 1] + 1;
    store.write(b, columns::kCluster, column);
    context.advance(store.blocks()[b].points);
  });
  return clusters;
}

}  // namespace ilot
