// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/boundaries/boundaries_pass.h"

#include <algorithm>
#include <mutex>
#include <tuple>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/products/planes/boundaries/boundary_edges.h"
#include "engine/store/flushed.h"
#include "kernels/core/parallel.h"
#include "kernels/core/union_find.h"
#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/thinning.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerEdge = 96;  // while the rings of a plane are assembled and simplified
constexpr std::size_t kPlanesTogether = 256;
constexpr std::size_t kLargeBoundary = 1 << 16;  // points; above this, freed memory is returned between the steps

struct RunOfBlock {
  std::uint32_t block = 0;
  SeamRun run;
};

// The edges of the boundary of a plane, with points numbered by rank.
struct PlaneEdges {
  std::vector<std::uint64_t> points;  // points at which edges begin, ascending, in global order
  std::vector<Point2> places;         // places of these points
  std::vector<BoundaryEdge> edges;
};

// The seam edges of a plane from all blocks, ordered by their ends. Those of some points are read at a time.
class SeamEdges {
 public:
  SeamEdges(const Store& store, std::span<const RunOfBlock> runs) : store_(store), runs_(runs), left_(runs.size()) {
    std::uint64_t first = UINT64_MAX, last = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      left_[r] = {0, regions_, next_of(r, 0)};
      regions_ += runs[r].run.regions;
      count_ += runs[r].run.count;
      first = std::min(first, left_[r].next);
      last = std::max(last, next_of(r, runs[r].run.count - 1));
    }
    if (!runs.empty()) points_at_once_ = (last - first) / (count_ / kAtOnce + 1) + 1;
  }

  std::size_t count() const { return count_; }
  std::uint32_t regions() const { return regions_; }  // number of regions of all blocks

  // Gives some edges together with all edges that have the same ends, in the order of the ends, then of the blocks. The
  // result is empty when there are no more.
  std::vector<SeamEdge> some() {
    std::uint64_t next = UINT64_MAX;
    for (const Left& l : left_) next = std::min(next, l.next);
    std::vector<SeamEdge> edges;
    if (next == UINT64_MAX) return edges;
    for (std::size_t r = 0; r < left_.size(); ++r)
      if (left_[r].next < next + points_at_once_) take(r, next + points_at_once_, edges);
    std::stable_sort(edges.begin(), edges.end(),
                     [](const SeamEdge& a, const SeamEdge& b) { return ends_of(a) < ends_of(b); });
    return edges;
  }

 private:
  static constexpr std::uint64_t kAtOnce = 1 << 16;  // approximate number of edges
  struct Left {
    std::uint32_t at = 0, regions = 0;  // edges of the run that were taken; regions of the runs before it
    std::uint64_t next = UINT64_MAX;    // the smaller end of the next edge
  };

  std::uint64_t next_of(std::size_t r, std::uint32_t at) const {
    return ends_of(store_.open(runs_[r].block, columns::kSeamEdges).at(runs_[r].run.first + at)).first;
  }

  void take(std::size_t r, std::uint64_t end, std::vector<SeamEdge>& edges) {
    constexpr std::uint32_t kBatch = 1024;
    const auto reader = store_.open(runs_[r].block, columns::kSeamEdges);
    Left& l = left_[r];
    std::vector<SeamEdge> batch;
    while (l.at < runs_[r].run.count) {
      batch.resize(std::min(kBatch, runs_[r].run.count - l.at));
      reader.read(runs_[r].run.first + l.at, batch);
      for (SeamEdge& e : batch) {
        l.next = ends_of(e).first;
        if (l.next >= end) return;
        e.region += l.regions;
        edges.push_back(e);
        ++l.at;
      }
    }
    l.next = UINT64_MAX;
  }

  const Store& store_;
  std::span<const RunOfBlock> runs_;
  std::vector<Left> left_;
  std::uint64_t points_at_once_ = 1;
  std::size_t count_ = 0;
  std::uint32_t regions_ = 0;
};

// Calls inside(a, b) with the regions of two edges that two blocks give from both sides of one line. Calls use(edge)
// for each edge that is given once.
template <class Inside, class Use>
void each_edge(SeamEdges seams, const Inside& inside, const Use& use) {
  for (auto edges = seams.some(); !edges.empty(); edges = seams.some())
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i + 1 < edges.size() && ends_of(edges[i]) == ends_of(edges[i + 1])) {
        inside(edges[i].region, edges[i + 1].region);
        ++i;
      } else {
        use(edges[i]);
      }
    }
}

// Reads the edges twice: first to find their points and the regions that are one, then to number the edges. Every point
// where an edge ends is also a point where another edge begins, because the edges of a region form closed rings.
PlaneEdges edges_of_plane(const Store& store, const std::vector<RunOfBlock>& runs) {
  const SeamEdges seams(store, runs);
  std::vector<std::uint32_t> parent(seams.regions());
  UnionFind united(parent);
  PlaneEdges out;
  out.points.reserve(seams.count());
  each_edge(
      seams, [&](std::uint32_t a, std::uint32_t b) { united.unite(a, b); },
      [&](const SeamEdge& e) { out.points.push_back(e.from); });
  out.edges.reserve(out.points.size());
  std::sort(out.points.begin(), out.points.end());
  out.points.erase(std::unique(out.points.begin(), out.points.end()), out.points.end());
  out.places.resize(out.points.size());
  const auto rank = [&](std::uint64_t point) {
    return static_cast<std::uint32_t>(std::lower_bound(out.points.begin(), out.points.end(), point) -
                                      out.points.begin());
  };
  each_edge(
      seams, [](std::uint32_t, std::uint32_t) {},
      [&](const SeamEdge& e) {
        out.edges.push_back({rank(e.from), rank(e.to), united.find(e.region)});
        out.places[out.edges.back().from] = e.at;
      });
  std::sort(out.edges.begin(), out.edges.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::tie(a.region, a.from, a.to) < std::tie(b.region, b.from, b.to);
  });
  return out;
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

// Marks the points of the store, by number, that are vertices of outlines.
class Vertices {
 public:
  explicit Vertices(std::uint64_t points) : marked_(points) {}

  void mark(const std::vector<std::uint64_t>& points) {
    const std::lock_guard lock(mutex_);
    for (const std::uint64_t point : points) marked_[point] = true;
  }
  void mark(const std::vector<std::uint32_t>& vertices, const std::vector<std::uint64_t>& points) {
    const std::lock_guard lock(mutex_);
    for (const std::uint32_t v : vertices) marked_[points[v]] = true;
  }
  bool operator[](std::uint64_t point) const { return marked_[point]; }

 private:
  std::mutex mutex_;
  std::vector<bool> marked_;
};

Outline boundary_of(const Store& store, const BoundaryParams& params, std::uint32_t id,
                    const std::vector<RunOfBlock>& runs, Vertices& marked) {
  PlaneEdges plane = edges_of_plane(store, runs);
  const std::span<const Point2> places = plane.places;
  const bool large = places.size() >= kLargeBoundary;
  if (large) trim_memory();
  const bool holes = params.erosion != Erosion::outside;
  if (holes) marked.mark(std::exchange(plane.points, {}));  // each point is on a ring
  Polygons rings = assemble_rings(plane.edges, places);
  std::vector<BoundaryEdge>().swap(plane.edges);
  if (!holes) {
    rings = outer_rings(rings, places);
    marked.mark(rings.vertices, plane.points);
  }
  if (large) trim_memory();
  return outline_of(thin_rings(rings, places, params.tolerance * kPlaneSteps), places, params.planes[id - 1], id,
                    store.unit());
}

void write_flags(const Store& store, const std::vector<std::uint64_t>& first, const Vertices& is_vertex,
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

// Writes the edges of each block, in parallel. What an interrupted run has completed is not done again.
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
                     const std::function<void(Outline)>& take) {
  const BoundaryWork work = boundary_work(store, params, context);
  edges_of_blocks(store, work, context);
  std::vector<std::vector<RunOfBlock>> runs(params.planes.size() + 1);
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    for (const SeamRun& r : store.read(b, columns::kSeamRuns)) runs[r.plane].push_back({b, r});
  Vertices is_vertex(store.points());
  const std::uint64_t budget = context.budget_bytes - std::min(context.budget_bytes / 2, store.points() / 8);
  for (std::size_t done = 1; done < runs.size(); done += kPlanesTogether) {
    const std::size_t count = std::min(kPlanesTogether, runs.size() - done);
    std::vector<Outline> batch(count);
    std::vector<PassTask> tasks(count);
    for (std::size_t i = 0; i < count; ++i)
      for (const RunOfBlock& r : runs[done + i]) tasks[i].bytes += r.run.count * kBytesPerEdge;
    run_pass(tasks, budget, [&](std::size_t i) {
      batch[i] = boundary_of(store, params, static_cast<std::uint32_t>(done + i), runs[done + i], is_vertex);
    });
    for (Outline& outline : batch) take(std::move(outline));
  }
  write_flags(store, work.first, is_vertex, budget);
  flush_pass(store, Pass::boundaries);
}

}  // namespace ilot
