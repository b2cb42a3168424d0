// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/boundary_edges.h"

#include <algorithm>
#include <cmath>

#include "engine/store/view.h"
#include "kernels/core/union_find.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {
namespace {

constexpr std::uint32_t kStretch = std::uint32_t{1} << 16;  // most points looked at together
constexpr std::uint64_t kBytesPerPoint = 280;               // of a stretch and its surroundings: the triangulation
constexpr int kNeighbours = 6;
constexpr double kPi = 3.14159265358979323846;

// The points of one octree cell of a block, and their box.
struct Stretch {
  std::uint32_t block = 0, first = 0, count = 0;
  IndexBox box;
};

Stretch stretch_of(std::uint32_t block, Tile tile, std::span<const std::uint64_t> codes, std::uint32_t first,
                   std::uint32_t count) {
  Stretch s{block, first, count, {{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}}};
  for (const std::uint64_t code : codes.subspan(first, count)) {
    const Index3 p = index_of({tile, code});
    s.box.min = {std::min(s.box.min.x, p.x), std::min(s.box.min.y, p.y), std::min(s.box.min.z, p.z)};
    s.box.max = {std::max(s.box.max.x, p.x), std::max(s.box.max.y, p.y), std::max(s.box.max.z, p.z)};
  }
  return s;
}

// Cells are cut until they are small enough: compact ones have little around them.
void cut(const Node& node, std::uint32_t block, std::span<const std::uint64_t> codes, std::uint32_t first,
         std::uint32_t count, std::vector<Stretch>& out) {
  if (count == 0) return;
  if (count <= kStretch || node.level == kTileBits) {
    out.push_back(stretch_of(block, node.tile, codes, first, count));
    return;
  }
  const std::uint32_t end = first + count;
  for (int octant = 0; octant < 8; ++octant) {
    const Node child = node.child(octant);
    const auto last = std::upper_bound(codes.begin() + first, codes.begin() + end, child.last_code());
    const auto next = static_cast<std::uint32_t>(last - codes.begin());
    cut(child, block, codes, first, next - first, out);
    first = next;
  }
}

std::vector<Stretch> stretches(const Store& store, std::uint32_t block) {
  std::vector<Stretch> all;
  const auto codes = store.read<std::uint64_t>(block, "codes");
  cut(store.blocks()[block].node, block, codes, 0, store.blocks()[block].points, all);
  return all;
}

std::int64_t farthest_of(const BoundaryParams& params, const Stretch& s) {
  std::int64_t farthest = 1;
  for (const NeighbourRange& r : params.ranges[s.block])
    if (r.first < s.first + s.count && s.first < r.first + r.count) farthest = std::max(farthest, r.farthest);
  return farthest;
}

// In the steps of a frame; the search for neighbours takes no more.
std::int64_t in_steps(std::int64_t units) {
  return std::min(std::int64_t{1} << 22, units * static_cast<std::int64_t>(kPlaneSteps));
}

double reach_of(double squared_steps, double gamma) {
  return gamma * std::sqrt(2 * kPi * squared_steps / kNeighbours);
}

// The points of one plane around a stretch.
struct PlanePoints {
  std::uint32_t plane = 0;             // final id
  std::vector<std::uint32_t> in_view;  // ascending
  std::vector<Point2> places;
  std::vector<std::uint8_t> own;  // 1 = of the stretch
};

// A stretch with what lies within `margin` around it.
class Surroundings {
 public:
  Surroundings(const Store& store, const Stretch& stretch, std::int64_t margin, const BoundaryParams& params)
      : stretch_(stretch),
        view_(load_view(store, stretch.box.grown(margin), store.blocks()[stretch.block].node.min_corner())),
        plane_(load_column<std::uint32_t>(store, view_, "plane")),
        params_(params) {
    for (std::uint32_t& p : plane_) p = params.final_id[p];
  }

  const View& view() const { return view_; }

  bool is_own(const Slice& s, std::uint32_t i) const {
    const std::uint32_t point = s.first + (i - s.at);
    return s.block == stretch_.block && point >= stretch_.first && point < stretch_.first + stretch_.count;
  }

  // One after the other, by id, the planes that points of the stretch lie on.
  template <class Use>
  void each_plane(const Use& use) const {
    std::vector<std::uint32_t> own;
    for (const Slice& s : view_.slices)
      for (std::uint32_t i = s.at; i < s.at + s.count; ++i)
        if (plane_[i] != 0 && is_own(s, i)) own.push_back(plane_[i]);
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    std::vector<std::vector<std::uint32_t>> members(own.size());
    for (std::uint32_t i = 0; i < plane_.size(); ++i) {
      const auto at = std::lower_bound(own.begin(), own.end(), plane_[i]);
      if (at != own.end() && *at == plane_[i]) members[static_cast<std::size_t>(at - own.begin())].push_back(i);
    }
    for (std::size_t p = 0; p < own.size(); ++p) use(placed(own[p], std::move(members[p])));
  }

 private:
  PlanePoints placed(std::uint32_t plane, std::vector<std::uint32_t> members) const {
    PlanePoints out{plane, std::move(members), {}, {}};
    const JoinedPlane& joined = params_.planes[plane - 1];
    const PlaneFrame frame = frame_of_joined(joined);
    std::size_t slice = 0;
    for (const std::uint32_t i : out.in_view) {
      const Index3 p = view_.position(i);
      out.places.push_back(
          project(frame, {static_cast<double>(p.x - joined.anchor.x), static_cast<double>(p.y - joined.anchor.y),
                          static_cast<double>(p.z - joined.anchor.z)}));
      while (i >= view_.slices[slice].at + view_.slices[slice].count) ++slice;
      out.own.push_back(is_own(view_.slices[slice], i) ? 1 : 0);
    }
    return out;
  }

  Stretch stretch_;
  View view_;
  std::vector<std::uint32_t> plane_;
  const BoundaryParams& params_;
};

// In units of space, for triangles that points of the largest reach own.
std::int64_t margin_of(double largest, const BoundaryWork& work) {
  return shape_halo(TriangleRule::kCircumradius, largest) / static_cast<std::int64_t>(kPlaneSteps) + work.across;
}

// The edges of triangles whose other side is not among them.
void add_edges(const PlanePoints& points, const Triangulation& t, const std::vector<std::uint32_t>& triangles,
               const std::vector<std::uint64_t>& number, std::uint32_t& regions, std::vector<SeamEdge>& edges) {
  std::vector<std::uint32_t> place(t.triangles(), kNoEdge), parent(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) place[triangles[i]] = i;
  UnionFind joined(parent);
  const auto other = [&](std::uint32_t e) { return t.twin[e] == kNoEdge ? kNoEdge : place[t.twin[e] / 3]; };
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t e = 3 * triangles[i]; e < 3 * triangles[i] + 3; ++e)
      if (other(e) != kNoEdge) joined.unite(i, other(e));
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t e = 3 * triangles[i]; e < 3 * triangles[i] + 3; ++e)
      if (other(e) == kNoEdge) {
        const std::uint32_t a = t.corner[e], b = t.corner[next_edge(e)];
        edges.push_back({number[points.in_view[a]], number[points.in_view[b]], points.places[a],
                         regions + joined.find(i), points.plane});
      }
  regions += static_cast<std::uint32_t>(triangles.size());
}

}  // namespace

BoundaryWork boundary_work(const Store& store, const BoundaryParams& params) {
  BoundaryWork work{params, 0, {0}};
  double epsilon = 0;
  for (const JoinedPlane& p : params.planes) epsilon = std::max(epsilon, p.epsilon);
  work.across = static_cast<std::int64_t>(std::ceil(2 * epsilon)) + 2;  // and a unit for rounding
  for (const Block& b : store.blocks()) work.first.push_back(work.first.back() + b.points);
  return work;
}

PlaneFrame frame_of_joined(const JoinedPlane& plane) {
  return frame_of(plane.plane, {0, 0, 0});
}

std::uint64_t boundary_bytes(const Store& store, std::uint32_t block, const BoundaryWork& work) {
  const BoundaryParams& params = work.params;
  std::uint64_t most = 0;
  for (const Stretch& s : stretches(store, block)) {
    const double largest = reach_of(std::pow(static_cast<double>(in_steps(farthest_of(params, s))), 2), params.gamma);
    const IndexBox box = s.box.grown(std::max(margin_of(largest, work), farthest_of(params, s)));
    most = std::max<std::uint64_t>(most, plan_view(store, box, store.blocks()[block].node.min_corner()).size);
  }
  return most * kBytesPerPoint + store.blocks()[block].points * std::uint64_t{4};
}

void write_reach(const Store& store, std::uint32_t block, const BoundaryWork& work) {
  const BoundaryParams& params = work.params;
  std::vector<float> reach(store.blocks()[block].points);
  for (const Stretch& s : stretches(store, block)) {
    const Surroundings around(store, s, farthest_of(params, s) + work.across, params);
    std::vector<std::uint32_t> point(around.view().size);  // of the block
    for (const Slice& slice : around.view().slices)
      for (std::uint32_t i = slice.at; i < slice.at + slice.count; ++i) point[i] = slice.first + (i - slice.at);
    around.each_plane([&](const PlanePoints& p) {
      const MeasuredSteps steps = measured_steps(p.places, kNeighbours, in_steps(farthest_of(params, s)), p.own);
      auto range = params.ranges[block].begin();
      for (std::size_t i = 0; i < p.places.size(); ++i) {
        if (!p.own[i]) continue;
        const std::uint32_t at = point[p.in_view[i]];
        while (at >= range->first + range->count) ++range;
        const std::int64_t farthest = in_steps(range->farthest), limit = farthest * farthest;
        const std::int64_t d2 = steps.reach2[i] < 0 ? limit : std::min(limit, steps.reach2[i]);
        reach[at] = static_cast<float>(reach_of(static_cast<double>(d2), params.gamma));
      }
    });
  }
  store.write<float>(block, "reach", reach);
}

void write_seam_edges(const Store& store, std::uint32_t block, const BoundaryWork& work) {
  const BoundaryParams& params = work.params;
  std::vector<SeamEdge> edges;
  std::vector<Coincident> coincident;
  std::uint32_t regions = 0;
  for (const Stretch& s : stretches(store, block)) {
    float largest = 0;
    for (const float r : store.read<float>(block, "reach", s.first, s.count)) largest = std::max(largest, r);
    if (largest == 0) continue;
    const Surroundings around(store, s, margin_of(largest, work), params);
    const auto reach_in_view = load_column<float>(store, around.view(), "reach");
    std::vector<std::uint64_t> number(around.view().size);
    for (const Slice& slice : around.view().slices)
      for (std::uint32_t i = slice.at; i < slice.at + slice.count; ++i)
        number[i] = work.first[slice.block] + slice.first + (i - slice.at);
    around.each_plane([&](const PlanePoints& p) {
      std::vector<float> reach;
      for (const std::uint32_t i : p.in_view) reach.push_back(reach_in_view[i]);
      const Triangulation t = delaunay(p.places);
      const auto own = owned_triangles(t, p.places, {TriangleRule::kCircumradius, reach}, p.own);
      add_edges(p, t, own, number, regions, edges);
      for (const auto& [left_out, kept] : t.duplicates)
        if (p.own[left_out])
          coincident.push_back(
              {static_cast<std::uint32_t>(number[p.in_view[left_out]] - work.first[block]), number[p.in_view[kept]]});
    });
  }
  std::stable_sort(edges.begin(), edges.end(), [](const SeamEdge& a, const SeamEdge& b) { return a.plane < b.plane; });
  std::vector<SeamRun> runs;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (runs.empty() || runs.back().plane != edges[i].plane) runs.push_back({edges[i].plane, i, 0});
    ++runs.back().count;
  }
  store.write<Coincident>(block, "coincident", coincident);
  store.write<SeamRun>(block, "seam_runs", runs);
  store.write<SeamEdge>(block, "seam_edges", edges);
}

}  // namespace ilot
