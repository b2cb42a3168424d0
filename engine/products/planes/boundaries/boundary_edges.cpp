// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/boundaries/boundary_edges.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/parallel.h"
#include "kernels/core/union_find.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/place_neighbours.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {
namespace {

// The sampling step from the distance of the sixth neighbour; -1 = there are fewer neighbours within `farthest`.
double measured_step(std::int64_t squared, std::int64_t farthest) {
  const std::int64_t limit = farthest * farthest;
  return raster_step(static_cast<double>(squared < 0 ? limit : std::min(limit, squared)), kStepNeighbours);
}

// The thresholds of the places of one plane.
class Thresholds {
 public:
  Thresholds(const PlanePlaces& places, const BoundaryParams& params)
      : places_(places), params_(params), joined_(params.planes[places.plane - 1]), frame_(frame_of_joined(joined_)) {
    const Vec3 anchor{static_cast<double>(joined_.anchor.x), static_cast<double>(joined_.anchor.y),
                      static_cast<double>(joined_.anchor.z)};
    for (Scanner s : params.stations) {
      s.position = s.position - anchor;
      stations_.push_back(s);
    }
  }

  void find(const std::vector<std::uint32_t>& wanted, std::vector<float>& reach) const {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t i : wanted) {
      if (params_.threshold > 0) {
        reach[i] = static_cast<float>(params_.threshold * kPlaneSteps);
      } else if (!predict(i, reach[i])) {
        left.push_back(i);
      }
    }
    if (!left.empty()) measure(left, reach);
  }

 private:
  // Takes the threshold from the stations; returns false where none sees the plane there.
  bool predict(std::uint32_t i, float& reach) const {
    if (stations_.empty()) return false;
    const double step =
        kPlaneSteps * predicted_step(stations_, joined_.plane, position(frame_, places_.order.points[i]));
    if (!std::isfinite(step)) return false;
    reach = static_cast<float>(params_.gamma * std::min(step, measured_step(-1, places_.farthest[i])));
    return true;
  }

  // Takes the threshold from the distance of the sixth neighbour.
  void measure(const std::vector<std::uint32_t>& queries, std::vector<float>& reach) const {
    std::int64_t farthest = 1;
    for (const std::uint32_t i : queries) farthest = std::max(farthest, places_.farthest[i]);
    std::vector<std::int64_t> squared(queries.size());
    kth_distances(place_cells(places_.order), queries, kStepNeighbours, farthest, squared);
    for (std::size_t q = 0; q < queries.size(); ++q)
      reach[queries[q]] = static_cast<float>(params_.gamma * measured_step(squared[q], places_.farthest[queries[q]]));
  }

  const PlanePlaces& places_;
  const BoundaryParams& params_;
  const JoinedPlane& joined_;
  PlaneFrame frame_;
  std::vector<Scanner> stations_;  // relative to the anchor of the plane
};

template <class Wanted>
std::vector<std::uint32_t> positions_where(std::size_t count, const Wanted& wanted) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < count; ++i)
    if (wanted(i)) all.push_back(i);
  return all;
}

// The places that the triangles of a stretch need.
struct NeededPlaces {
  PlaneOrder order;  // its indices are points of the BoundarySurroundings
  std::vector<float> reach;
  std::vector<std::uint8_t> own;
};

NeededPlaces needed_places(const PlanePlaces& p, const BoundaryParams& params) {
  const std::size_t n = p.order.points.size();
  const Thresholds thresholds(p, params);
  std::vector<float> reach(n);
  thresholds.find(positions_where(n, [&](std::uint32_t i) { return p.own[i] == 1; }), reach);
  const auto needed = needed_points(params.rule, p.order.points, reach, p.own);
  thresholds.find(positions_where(n, [&](std::uint32_t i) { return needed[i] > p.own[i]; }), reach);
  NeededPlaces out{selected(p.order, needed), {}, {}};
  for (std::size_t i = 0; i < n; ++i)
    if (needed[i]) {
      out.reach.push_back(reach[i]);
      out.own.push_back(p.own[i]);
    }
  return out;
}

// The edges that a stretch adds to its block.
struct OwnedEdges {
  std::vector<SeamEdge> edges;
  std::vector<Coincident> coincident;
  std::uint32_t regions = 0;
};

// Adds the edges of triangles that have no triangle of the list on their other side.
void add_edges(const BoundarySurroundings& around, std::uint32_t plane, const PlaneOrder& order, const Triangulation& t,
               const std::vector<std::uint32_t>& triangles, OwnedEdges& out) {
  std::vector<std::uint32_t> place(t.triangles(), kNoEdge), parent(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) place[triangles[i]] = i;
  UnionFind joined(parent);
  const auto other = [&](std::uint32_t e) { return t.twin[e] == kNoEdge ? kNoEdge : place[t.twin[e] / 3]; };
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t e = 3 * triangles[i]; e < 3 * triangles[i] + 3; ++e) {
      const std::uint32_t o = other(e);
      if (o == kNoEdge) {
        open.push_back(e);
      } else if (o < i) {
        joined.unite(i, o);
      }
    }
  std::vector<std::uint32_t> region(triangles.size(), kNoEdge);  // region of each root triangle
  for (const std::uint32_t e : open) {
    const std::uint32_t a = t.corner[e], b = t.corner[next_edge(e)];
    std::uint32_t& r = region[joined.find(place[e / 3])];
    if (r == kNoEdge) r = out.regions++;
    out.edges.push_back({around.number(order.index[a]), around.number(order.index[b]), order.points[a], r, plane});
  }
}

OwnedEdges owned_edges(const Store& store, const BoundaryStretch& stretch, const BoundaryWork& work) {
  OwnedEdges out;
  const BoundarySurroundings around(store, stretch, work);
  around.each_plane([&](const PlanePlaces& p) {
    for (const auto& [left_out, kept] : p.order.duplicates)
      if (around.is_inside(left_out))
        out.coincident.push_back(
            {static_cast<std::uint32_t>(around.number(left_out) - work.first[stretch.block]), around.number(kept)});
    if (std::find(p.own.begin(), p.own.end(), 1) == p.own.end()) return;
    const NeededPlaces needed = needed_places(p, work.params);
    const Triangulation t = delaunay(needed.order);
    const std::vector<std::int32_t> heights = work.params.edge_length == EdgeLength::space
                                                  ? around.heights(p.plane, needed.order.index)
                                                  : std::vector<std::int32_t>();
    const auto own = owned_triangles(t, needed.order.points, {work.params.rule, needed.reach, heights, {}}, needed.own);
    add_edges(around, p.plane, needed.order, t, own, out);
  });
  return out;
}

}  // namespace

void write_seam_edges(const Store& store, std::uint32_t block, const BoundaryWork& work) {
  const std::span<const BoundaryStretch> all = work.of(block);
  std::vector<OwnedEdges> owned(all.size());
  parallel_for(all.size(), [&](std::size_t i) { owned[i] = owned_edges(store, all[i], work); });
  std::vector<SeamEdge> edges;
  std::vector<Coincident> coincident;
  std::uint32_t regions = 0;
  for (OwnedEdges& o : owned) {
    for (SeamEdge& e : o.edges) e.region += regions;
    edges.insert(edges.end(), o.edges.begin(), o.edges.end());
    coincident.insert(coincident.end(), o.coincident.begin(), o.coincident.end());
    regions += o.regions;
    o = {};
  }
  std::stable_sort(edges.begin(), edges.end(), [](const SeamEdge& a, const SeamEdge& b) {
    return std::pair(a.plane, ends_of(a)) < std::pair(b.plane, ends_of(b));
  });
  std::vector<SeamRun> runs;
  std::vector<std::uint32_t> number(regions, kNoEdge);  // number of each region within its run
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (runs.empty() || runs.back().plane != edges[i].plane) runs.push_back({edges[i].plane, i});
    ++runs.back().count;
    std::uint32_t& n = number[edges[i].region];
    if (n == kNoEdge) n = runs.back().regions++;
    edges[i].region = n;
  }
  store.write(block, columns::kCoincident, coincident);
  store.write(block, columns::kSeamRuns, runs);
  store.write(block, columns::kSeamEdges, edges);
}

}  // namespace ilot
