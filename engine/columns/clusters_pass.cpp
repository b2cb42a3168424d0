// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/clusters_pass.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/store/flushed.h"
#include "engine/store/view.h"
#include "engine/units/unit_stretches.h"
#include "kernels/core/parallel.h"
#include "kernels/core/union_find.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/clusters.h"

namespace ilot {
namespace {

constexpr std::uint64_t kClusterBytesPerPoint = 112;

IndexBox column_around(const IndexBox& box, std::int64_t by) {
  return column_over(box.min.x - by, box.min.y - by, box.max.x + by, box.max.y + by);
}

// The number of points in plan that are searched for links at a time.
constexpr std::uint64_t kMostLinked = 1u << 17;

void add(CloudCluster& cluster, Index3 p) {
  if (cluster.points++ == 0) {
    cluster.first = p;
    cluster.box = {p, p};
  }
  cluster.box.add(p);
}

void add(CloudCluster& sum, const CloudCluster& part) {
  sum.box.add_box(part.box);
  sum.points += part.points;
}

// The clusters of the own points of one block, numbered by their first points; column "cluster_part".
std::vector<CloudCluster> parts_of_block(const Store& store, std::uint32_t block, const ClusterParams& params) {
  const Block& b = store.blocks()[block];
  View view;
  view.anchor = b.node.min_corner();
  view.slices.push_back({block, 0, b.points, 0});
  view.size = b.points;
  load_points(store, view);
  const auto roles = store.read(block, columns::kRole);
  std::vector<std::uint32_t> chosen, part(b.points, 0);
  chosen.reserve(static_cast<std::size_t>(std::count(roles.begin(), roles.end(), params.role)));
  for (std::uint32_t i = 0; i < b.points; ++i)
    if (roles[i] == params.role) chosen.push_back(i);
  std::vector<float> heights(view.z.size(), 0.0f);  // heights do not count in the distances
  std::swap(heights, view.z);
  const Clusters found = euclidean_clusters(view.points(), chosen, params.radius);
  std::swap(heights, view.z);
  std::vector<CloudCluster> clusters(found.count);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    add(clusters[found.id[i]], view.position(chosen[i]));
    part[chosen[i]] = found.id[i] + 1;
  }
  store.write(block, columns::kClusterPart, part);
  return clusters;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// The points of parts in a column of space, relative to its corner, without heights.
struct PlanPoints : PaddedPoints {
  std::vector<std::uint32_t> part;
};

PlanPoints points_in(const Store& store, const IndexBox& box, const std::vector<std::uint32_t>& first) {
  PlanPoints points;
  for_each_stretch_in(store, box, [&](const Stretch& s, std::span<const StretchPoint> inside) {
    const auto parts = s.read(store, columns::kClusterPart);
    for (const StretchPoint& p : inside) {
      if (parts[p.number] == 0) continue;
      points.add(static_cast<float>(p.position.x - box.min.x), static_cast<float>(p.position.y - box.min.y), 0);
      points.part.push_back(first[s.block] + parts[p.number] - 1);
    }
  });
  points.pad();
  return points;
}

// Adds links between parts that are connected in the box. The parts have points in the box or within the radius of it.
// Where there are many points, a quarter of the box is processed at a time: of two points that are near each other, at
// least one is in it.
void add_links(const Store& store, const IndexBox& box, const ClusterParams& params,
               const std::vector<std::uint32_t>& first, std::vector<Pair>& links) {
  const IndexBox read = column_around(box, params.radius);
  const std::int64_t width = box.max.x - box.min.x, height = box.max.y - box.min.y;
  if (std::max(width, height) > params.radius && plan_view(store, read, {}).size > kMostLinked) {
    const std::int64_t x = box.min.x + width / 2, y = box.min.y + height / 2;
    for (const auto& [x0, x1] : {std::pair{box.min.x, x}, std::pair{x + 1, box.max.x}})
      for (const auto& [y0, y1] : {std::pair{box.min.y, y}, std::pair{y + 1, box.max.y}})
        if (x0 <= x1 && y0 <= y1) add_links(store, {{x0, y0, box.min.z}, {x1, y1, box.max.z}}, params, first, links);
    return;
  }
  const PlanPoints points = points_in(store, read, first);
  std::vector<std::uint32_t> all(points.part.size());
  std::iota(all.begin(), all.end(), 0u);
  const Clusters found = euclidean_clusters(points.points(), all, params.radius);
  std::vector<std::uint32_t> first_part(found.count, UINT32_MAX);
  const auto before = static_cast<std::ptrdiff_t>(links.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::uint32_t& leader = first_part[found.id[i]];
    if (leader == UINT32_MAX) leader = points.part[i];
    const Pair link{leader, points.part[i]};
    if (link.first != link.second && (links.empty() || links.back() != link)) links.push_back(link);
  }
  std::sort(links.begin() + before, links.end());
  links.erase(std::unique(links.begin() + before, links.end()), links.end());
}

// Finds the parts of different blocks that are connected around this block. `first` has for each block the number of
// its first part.
std::vector<Pair> links_of_block(const Store& store, std::uint32_t block, const ClusterParams& params,
                                 const std::vector<std::uint32_t>& first) {
  const IndexBox& box = store.blocks()[block].box;
  if (store.blocks_in(column_around(box, params.radius)).size() < 2) return {};
  std::vector<Pair> links;
  add_links(store, box, params, first, links);
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

template <class Body>
void for_each_block(const Store& store, const PassContext& context, const Body& body) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kClusterBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) { body(static_cast<std::uint32_t>(i)); });
}

}  // namespace

std::vector<CloudCluster> clusters_pass(const Store& store, const ClusterParams& params, const PassContext& context) {
  const std::size_t blocks = store.blocks().size();
  std::vector<std::vector<CloudCluster>> parts(blocks);
  for_each_block(store, context, [&](std::uint32_t b) { parts[b] = parts_of_block(store, b, params); });
  std::vector<std::uint32_t> first(blocks);
  std::uint32_t count = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    first[b] = count;
    count += static_cast<std::uint32_t>(parts[b].size());
  }
  std::vector<std::vector<Pair>> links(blocks);
  std::vector<PassTask> tasks(blocks);
  parallel_for(blocks, [&](std::size_t b) {
    const std::uint64_t around = plan_view(store, column_around(store.blocks()[b].box, params.radius), {}).size;
    tasks[b] = {std::min(around, kMostLinked) * kClusterBytesPerPoint, store.blocks()[b].points};
  });
  run_pass(tasks, context.budget_bytes,
           [&](std::size_t b) { links[b] = links_of_block(store, static_cast<std::uint32_t>(b), params, first); });

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
  for_each_block(store, context, [&](std::uint32_t b) {
    auto column = store.read(b, columns::kClusterPart);
    for (std::uint32_t& c : column) c = c == 0 ? 0 : number[first[b] + c - 1] + 1;
    store.write(b, columns::kCluster, column);
    context.advance(store.blocks()[b].points);
  });
  flush_pass(store, Pass::clusters);
  return clusters;
}

}  // namespace ilot
