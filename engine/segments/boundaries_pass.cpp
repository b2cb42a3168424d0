// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/boundaries_pass.h"

#include <algorithm>
#include <map>

#include "engine/pass/pass.h"
#include "engine/segments/boundary_edges.h"
#include "kernels/core/union_find.h"
#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/thinning.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerEdge = 200;  // while a plane's rings are assembled
constexpr std::size_t kPlanesTogether = 256;

struct RunOfBlock {
  std::uint32_t block = 0;
  SeamRun run;
};

// A seam edge with its region numbered over all blocks.
struct Edge {
  std::uint64_t from = 0, to = 0;
  Point2 at;
  std::uint32_t region = 0;
};

struct PlaneBoundary {
  Outline outline;
  std::vector<std::uint64_t> vertices;  // points in global order
};

std::vector<Edge> read_edges(const Store& store, const std::vector<RunOfBlock>& runs) {
  std::vector<Edge> edges;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> regions;
  for (const RunOfBlock& r : runs)
    for (const SeamEdge& e : store.read<SeamEdge>(r.block, "seam_edges", r.run.first, r.run.count)) {
      const auto next = static_cast<std::uint32_t>(regions.size());
      edges.push_back({e.from, e.to, e.at, regions.try_emplace({r.block, e.region}, next).first->second});
    }
  return edges;
}

// Takes out the edges that two blocks give from both sides, and joins the regions that meet there.
std::vector<Edge> joined(std::vector<Edge> edges) {
  const auto key = [](const Edge& e) { return std::pair(std::min(e.from, e.to), std::max(e.from, e.to)); };
  std::sort(edges.begin(), edges.end(),
            [&](const Edge& a, const Edge& b) { return key(a) != key(b) ? key(a) < key(b) : a.from < b.from; });
  std::vector<std::uint32_t> parent(edges.size());
  UnionFind regions(parent);
  std::vector<Edge> left;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + 1 < edges.size() && key(edges[i]) == key(edges[i + 1])) {
      regions.unite(edges[i].region, edges[i + 1].region);
      ++i;
    } else {
      left.push_back(edges[i]);
    }
  }
  for (Edge& e : left) e.region = regions.find(e.region);
  return left;
}

Outline outline_of(const Polygons& polygons, std::span<const Point2> places, const JoinedPlane& plane, std::uint32_t id,
                   double unit) {
  Outline out{id, std::vector<Outline::Part>(polygons.count)};
  const PlaneFrame frame = frame_of_joined(plane);
  for (const Ring& ring : polygons.rings) {
    Outline::Ring& points = out.parts[ring.polygon].emplace_back();
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      const Vec3 p = position(frame, places[polygons.vertices[ring.first + i]]);
      points.push_back({(static_cast<double>(plane.anchor.x) + p.x) * unit,
                        (static_cast<double>(plane.anchor.y) + p.y) * unit,
                        (static_cast<double>(plane.anchor.z) + p.z) * unit});
    }
  }
  return out;
}

PlaneBoundary boundary_of(const Store& store, const BoundaryParams& params, std::uint32_t id,
                          const std::vector<RunOfBlock>& runs) {
  const std::vector<Edge> edges = joined(read_edges(store, runs));
  std::vector<std::uint64_t> points;
  for (const Edge& e : edges) points.push_back(e.from);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto local = [&](std::uint64_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), v) - points.begin());
  };
  std::vector<Point2> places(points.size());
  std::vector<BoundaryEdge> boundary;
  for (const Edge& e : edges) {
    boundary.push_back({local(e.from), local(e.to), e.region});
    places[boundary.back().from] = e.at;
  }
  Polygons rings = assemble_rings(boundary, places);
  if (params.erosion == Erosion::outside) rings = outer_rings(rings, places);
  PlaneBoundary result;
  for (const std::uint32_t v : rings.vertices) result.vertices.push_back(points[v]);
  result.outline = outline_of(thin_rings(rings, places, params.tolerance * kPlaneSteps), places, params.planes[id - 1],
                              id, store.unit());
  return result;
}

void write_flags(const Store& store, const std::vector<std::uint64_t>& first, const std::vector<bool>& is_vertex) {
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    if (store.has(b, "boundary")) continue;
    std::vector<std::uint8_t> flags(store.blocks()[b].points);
    for (std::uint32_t i = 0; i < flags.size(); ++i) flags[i] = is_vertex[first[b] + i] ? 1 : 0;
    for (const Coincident& c : read_column<Coincident>(store.path(b, "coincident")))
      flags[c.point] = is_vertex[c.kept] ? 1 : 0;
    store.write<std::uint8_t>(b, "boundary", flags);
  }
}

// Per block in parallel, each once: what a killed run has done is not done again.
void edges_of_blocks(const Store& store, const BoundaryWork& work, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    tasks.push_back({boundary_bytes(store, b, work), store.blocks()[b].points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, "seam_edges")) write_seam_edges(store, block, work);
    context.advance(store.blocks()[block].points);
  });
}

}  // namespace

std::vector<std::vector<NeighbourRange>> neighbour_ranges(const Store& store, const std::vector<Cell>& cells,
                                                          const CellPlanes& cell_planes) {
  std::vector<std::vector<NeighbourRange>> all;
  for (const BlockCells& block : cells_of_blocks(store, cells, cell_planes)) {
    auto& ranges = all.emplace_back();
    for (const BlockCells::Range& r : block.ranges)
      ranges.push_back({r.first, r.count, 2 * cell_planes.cells[r.cell].connectivity});
  }
  return all;
}

void boundaries_pass(const Store& store, const BoundaryParams& params, const PassContext& context,
                     const std::function<void(const Outline&)>& take) {
  const BoundaryWork work = boundary_work(store, params, context);
  edges_of_blocks(store, work, context);
  std::vector<std::vector<RunOfBlock>> runs(params.planes.size() + 1);
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    for (const SeamRun& r : read_column<SeamRun>(store.path(b, "seam_runs"))) runs[r.plane].push_back({b, r});
  std::vector<bool> is_vertex(store.points());
  const std::uint64_t budget = context.budget_bytes - std::min(context.budget_bytes / 2, store.points() / 8);
  for (std::size_t done = 1; done < runs.size(); done += kPlanesTogether) {
    const std::size_t count = std::min(kPlanesTogether, runs.size() - done);
    std::vector<PlaneBoundary> batch(count);
    std::vector<PassTask> tasks(count);
    for (std::size_t i = 0; i < count; ++i)
      for (const RunOfBlock& r : runs[done + i]) tasks[i].bytes += r.run.count * kBytesPerEdge;
    run_pass(tasks, budget, [&](std::size_t i) {
      batch[i] = boundary_of(store, params, static_cast<std::uint32_t>(done + i), runs[done + i]);
    });
    for (const PlaneBoundary& b : batch) {
      for (const std::uint64_t v : b.vertices) is_vertex[v] = true;
      take(b.outline);
    }
  }
  write_flags(store, work.first, is_vertex);
}

}  // namespace ilot
