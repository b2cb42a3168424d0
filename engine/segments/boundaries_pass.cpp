// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/boundaries_pass.h"

#include <algorithm>

#include "engine/pass/pass.h"
#include "engine/segments/boundary_edges.h"
#include "kernels/core/parallel.h"
#include "kernels/core/radix_sort.h"
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

struct PlaneBoundary {
  Outline outline;
  std::vector<std::uint64_t> vertices;  // points in global order
};

// The seam edges of a plane, its points numbered by rank and its regions over all blocks.
struct PlaneEdges {
  std::vector<std::uint64_t> points;  // that edges start at, ascending, in global order
  std::vector<Point2> places;         // of these
  std::vector<BoundaryEdge> edges;
};

std::vector<SeamEdge> read_edges(const Store& store, const std::vector<RunOfBlock>& runs) {
  std::size_t count = 0;
  for (const RunOfBlock& r : runs) count += r.run.count;
  std::vector<SeamEdge> edges(count);
  std::uint32_t regions = 0;
  std::size_t at = 0;
  for (const RunOfBlock& r : runs) {
    const auto part = std::span(edges).subspan(at, r.run.count);
    store.open(r.block, columns::kSeamEdges).read(r.run.first, part);
    for (SeamEdge& e : part) e.region += regions;
    regions += r.run.regions;
    at += part.size();
  }
  return edges;
}

// Every point where an edge ends is one where another starts: the edges of a region close.
PlaneEdges rank_points(const std::vector<SeamEdge>& edges) {
  PlaneEdges out;
  out.edges.resize(edges.size());
  std::vector<KeyValue> order(edges.size()), scratch(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    order[i] = {edges[i].from, i};
    out.edges[i].region = edges[i].region;
  }
  sort_pairs(order, scratch);
  for (const KeyValue& o : order) {
    if (out.points.empty() || out.points.back() != o.key) {
      out.points.push_back(o.key);
      out.places.push_back(edges[o.value].at);
    }
    out.edges[o.value].from = static_cast<std::uint32_t>(out.points.size() - 1);
  }
  for (std::size_t i = 0; i < edges.size(); ++i) order[i] = {edges[i].to, i};
  sort_pairs(order, scratch);
  std::uint32_t rank = 0;
  for (const KeyValue& o : order) {
    while (out.points[rank] < o.key) ++rank;
    out.edges[o.value].to = rank;
  }
  return out;
}

// Takes out the edges that two blocks give from both sides, and joins the regions that meet there.
std::vector<BoundaryEdge> joined(const std::vector<BoundaryEdge>& edges) {
  std::vector<KeyValue> order(edges.size());
  std::uint32_t regions = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::uint64_t a = std::min(edges[i].from, edges[i].to), b = std::max(edges[i].from, edges[i].to);
    order[i] = {a << 32 | b, i};
    regions = std::max(regions, edges[i].region + 1);
  }
  {
    std::vector<KeyValue> scratch(edges.size());
    sort_pairs(order, scratch);
  }
  std::vector<std::uint32_t> parent(regions);
  UnionFind united(parent);
  std::vector<BoundaryEdge> left;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const BoundaryEdge& edge = edges[order[i].value];
    if (i + 1 < order.size() && order[i].key == order[i + 1].key) {
      united.unite(edge.region, edges[order[i + 1].value].region);
      ++i;
    } else {
      left.push_back(edge);
    }
  }
  for (BoundaryEdge& e : left) e.region = united.find(e.region);
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
  PlaneEdges plane = rank_points(read_edges(store, runs));
  plane.edges = joined(plane.edges);
  const std::span<const Point2> places = plane.places;
  Polygons rings = assemble_rings(plane.edges, places);
  if (params.erosion == Erosion::outside) rings = outer_rings(rings, places);
  PlaneBoundary result;
  for (const std::uint32_t v : rings.vertices) result.vertices.push_back(plane.points[v]);
  result.outline = outline_of(thin_rings(rings, places, params.tolerance * kPlaneSteps), places, params.planes[id - 1],
                              id, store.unit());
  return result;
}

void write_flags(const Store& store, const std::vector<std::uint64_t>& first, const std::vector<bool>& is_vertex,
                 std::uint64_t budget) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * std::uint64_t{32}, b.points});
  run_pass(tasks, budget, [&](std::size_t i) {
    const auto b = static_cast<std::uint32_t>(i);
    if (store.has(b, columns::kBoundary)) return;
    std::vector<std::uint8_t> flags(store.blocks()[b].points);
    for (std::uint32_t p = 0; p < flags.size(); ++p) flags[p] = is_vertex[first[b] + p] ? 1 : 0;
    for (const Coincident& c : store.read(b, columns::kCoincident)) flags[c.point] = is_vertex[c.kept] ? 1 : 0;
    store.write(b, columns::kBoundary, flags);
  });
}

// Per block in parallel, each once: what a killed run has done is not done again.
void edges_of_blocks(const Store& store, const BoundaryWork& work, const PassContext& context) {
  std::vector<PassTask> tasks(store.blocks().size());
  parallel_for(tasks.size(), [&](std::size_t b) {
    const auto block = static_cast<std::uint32_t>(b);
    tasks[b] = {boundary_bytes(store, block, work), store.blocks()[b].points};
  });
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, columns::kSeamEdges)) write_seam_edges(store, block, work);
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
    for (const SeamRun& r : store.read(b, columns::kSeamRuns)) runs[r.plane].push_back({b, r});
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
  write_flags(store, work.first, is_vertex, budget);
}

}  // namespace ilot
