// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/boundary_edges.h"

#include <algorithm>
#include <cmath>

#include "engine/store/view.h"
#include "kernels/core/parallel.h"
#include "kernels/core/union_find.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/place_neighbours.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 280;  // of a stretch and its surroundings: the triangulation
constexpr int kNeighbours = 6;

IndexBox common(const IndexBox& a, const IndexBox& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

// Cells are cut until they are small enough: compact ones have little around them.
struct Cutter {
  std::uint32_t number, most;
  std::span<const std::uint64_t> codes;
  IndexBox box;  // around the points of the block
  std::vector<Stretch> out;

  void cut(const Node& node, std::uint32_t first, std::uint32_t count) {
    if (count == 0) return;
    if (count <= most || node.level == kTileBits) {
      out.push_back({node, number, first, count, common(node.box(), box)});
      return;
    }
    const std::uint32_t end = first + count;
    for (int octant = 0; octant < 8; ++octant) {
      const Node child = node.child(octant);
      const auto last = std::upper_bound(codes.begin() + first, codes.begin() + end, child.last_code());
      const auto next = static_cast<std::uint32_t>(last - codes.begin());
      cut(child, first, next - first);
      first = next;
    }
  }
};

std::vector<Stretch> cut_block(const Store& store, std::uint32_t block, std::uint32_t most, std::int64_t across) {
  const auto codes = store.read<std::uint64_t>(block, "codes");
  const Block& b = store.blocks()[block];
  Cutter cutter{block, most, codes, b.box.grown(across), {}};
  cutter.cut(b.node, 0, b.points);
  return std::move(cutter.out);
}

// Does some stretch hold this place?
bool is_held(const BoundaryWork& work, Index3 place) {
  const PointKey key = key_of(place);
  const auto after =
      std::upper_bound(work.stretches.begin(), work.stretches.end(), key, [](const PointKey& k, const Stretch& s) {
        return k < PointKey{s.node.tile, s.node.first_code};
      });
  return after != work.stretches.begin() && std::prev(after)->box.contains(place);
}

// In the steps of a frame; the search for neighbours takes no more.
std::int64_t in_steps(std::int64_t units) {
  return std::min(std::int64_t{1} << 22, units * static_cast<std::int64_t>(kPlaneSteps));
}

// The largest range of a run of points of a block.
std::int64_t farthest_of(std::span<const NeighbourRange> ranges, std::uint32_t first, std::uint32_t count) {
  std::int64_t farthest = 1;
  for (const NeighbourRange& r : ranges)
    if (r.first < first + count && first < r.first + r.count) farthest = std::max(farthest, r.farthest);
  return farthest;
}

// What is looked at for a stretch: all that its triangles' circles reach, and the neighbours of what lies there.
View plan_surroundings(const Store& store, const Stretch& s, const BoundaryWork& work, IndexBox& box) {
  const auto& ranges = work.params.ranges;
  const Index3 anchor = store.blocks()[s.block].node.min_corner();
  std::int64_t farthest_own = 1;
  for (const Slice& slice : plan_view(store, s.box.grown(work.across), anchor).slices)
    farthest_own = std::max(farthest_own, farthest_of(ranges[slice.block], slice.first, slice.count));
  const double own = static_cast<double>(in_steps(farthest_own));
  const double largest = work.params.threshold > 0 ? work.params.threshold * kPlaneSteps
                                                   : work.params.gamma * raster_step(own * own, kNeighbours);
  const std::int64_t circles =
      shape_halo(work.params.rule, largest) / static_cast<std::int64_t>(kPlaneSteps) + work.across;
  std::int64_t farthest = 1;
  for (const Slice& slice : plan_view(store, s.box.grown(circles + work.across), anchor).slices)
    farthest = std::max(farthest, farthest_of(ranges[slice.block], slice.first, slice.count));
  box = s.box.grown(circles + farthest + 2 * work.across);
  return plan_view(store, box, anchor);
}

// The points of one plane around a stretch, those at one place once.
struct PlanePlaces {
  std::uint32_t plane = 0;             // final id
  PlaneOrder order;                    // its indices: points of the view
  std::vector<std::uint8_t> own;       // per place, 1 = the stretch's
  std::vector<std::int64_t> farthest;  // per place, of its point's range, in steps
};

// A stretch with what lies around it.
class Surroundings {
 public:
  Surroundings(const Store& store, const Stretch& stretch, const BoundaryWork& work) : work_(work), stretch_(stretch) {
    IndexBox box;
    view_ = plan_surroundings(store, stretch, work, box);
    load_points(store, view_);
    plane_ = load_column<std::uint32_t>(store, view_, "plane");
    for (std::uint32_t i = 0; i < plane_.size(); ++i)
      plane_[i] = box.contains(view_.position(i)) ? work.params.final_id[plane_[i]] : 0;
    for (const Slice& s : view_.slices)
      if (s.block == stretch.block && s.first <= stretch.first && stretch.first < s.first + s.count)
        own_ = s.at + (stretch.first - s.first);
    own_end_ = own_ + stretch.count;
  }

  // A point of the stretch's own stretch of its block.
  bool is_inside(std::uint32_t i) const { return i >= own_ && i < own_end_; }

  // In global order.
  std::uint64_t number(std::uint32_t i) const {
    const Slice& s = *std::prev(std::upper_bound(view_.slices.begin(), view_.slices.end(), i,
                                                 [](std::uint32_t at, const Slice& t) { return at < t.at; }));
    return work_.first[s.block] + s.first + (i - s.at);
  }

  // Of points above a plane, in steps of its frame.
  std::vector<std::int32_t> heights(std::uint32_t plane, std::span<const std::uint32_t> points) const {
    const JoinedPlane& joined = work_.params.planes[plane - 1];
    std::vector<std::int32_t> heights;
    for (const std::uint32_t i : points)
      heights.push_back(static_cast<std::int32_t>(
          std::floor(kPlaneSteps * signed_distance(joined.plane, from_anchor(joined, i)) + 0.5)));
    return heights;
  }

  // One after the other, by id, the planes that have points of the stretch or next to it.
  template <class Use>
  void each_plane(const Use& use) const {
    std::vector<std::uint32_t> ids;
    const IndexBox near = stretch_.box.grown(work_.across);
    for (std::uint32_t i = 0; i < plane_.size(); ++i)
      if ((ids.empty() || ids.back() != plane_[i]) && near.contains(view_.position(i))) ids.push_back(plane_[i]);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<std::vector<std::uint32_t>> members(ids.size());
    std::uint32_t last = 0;
    std::vector<std::uint32_t>* of_last = nullptr;  // null: of a plane that is not asked for
    for (std::uint32_t i = 0; i < plane_.size(); ++i) {
      if (plane_[i] == 0) continue;
      if (plane_[i] != last) {
        last = plane_[i];
        const auto at = std::lower_bound(ids.begin(), ids.end(), last);
        of_last = at != ids.end() && *at == last ? &members[static_cast<std::size_t>(at - ids.begin())] : nullptr;
      }
      if (of_last != nullptr) of_last->push_back(i);
    }
    for (std::size_t p = 0; p < ids.size(); ++p)
      if (ids[p] != 0) use(placed(ids[p], members[p]));
  }

 private:
  // By where the foot lies; by the point itself where no stretch holds the foot.
  bool is_own(std::uint32_t i, Index3 foot) const {
    if (stretch_.box.contains(foot)) return true;
    return is_inside(i) && !is_held(work_, foot);
  }

  PlanePlaces placed(std::uint32_t plane, const std::vector<std::uint32_t>& members) const {
    const JoinedPlane& joined = work_.params.planes[plane - 1];
    const PlaneFrame frame = frame_of_joined(joined);
    std::vector<Point2> places;
    places.reserve(members.size());
    for (const std::uint32_t i : members) places.push_back(project(frame, from_anchor(joined, i)));
    const std::vector<std::int64_t> farthest = farthest_of_members(members);
    PlanePlaces out{plane, plane_order(places), {}, {}};
    for (std::size_t at = 0; at < out.order.index.size(); ++at) {
      std::uint32_t& i = out.order.index[at];
      out.farthest.push_back(farthest[i]);
      i = members[i];
      const Vec3 foot = position(frame, out.order.points[at]);
      const auto whole = [](double v) { return static_cast<std::int64_t>(std::floor(v + 0.5)); };
      out.own.push_back(
          is_own(i, {joined.anchor.x + whole(foot.x), joined.anchor.y + whole(foot.y), joined.anchor.z + whole(foot.z)})
              ? 1
              : 0);
    }
    for (auto& [left_out, kept] : out.order.duplicates) {
      left_out = members[left_out];
      kept = members[kept];
    }
    return out;
  }

  Vec3 from_anchor(const JoinedPlane& joined, std::uint32_t i) const {
    const Index3 p = view_.position(i);
    return {static_cast<double>(p.x - joined.anchor.x), static_cast<double>(p.y - joined.anchor.y),
            static_cast<double>(p.z - joined.anchor.z)};
  }

  std::vector<std::int64_t> farthest_of_members(const std::vector<std::uint32_t>& members) const {
    std::vector<std::int64_t> farthest;
    farthest.reserve(members.size());
    std::size_t slice = 0, range = 0;
    for (const std::uint32_t i : members) {
      while (i >= view_.slices[slice].at + view_.slices[slice].count) {
        ++slice;
        range = 0;
      }
      const Slice& s = view_.slices[slice];
      const std::uint32_t point = s.first + (i - s.at);
      const auto& ranges = work_.params.ranges[s.block];
      while (point >= ranges[range].first + ranges[range].count) ++range;
      farthest.push_back(in_steps(ranges[range].farthest));
    }
    return farthest;
  }

  const BoundaryWork& work_;
  const Stretch& stretch_;
  View view_;
  std::vector<std::uint32_t> plane_;  // final ids; 0 also beyond the box that is looked at
  std::uint32_t own_ = 0, own_end_ = 0;
};

// The step that the distance of the sixth neighbour tells; -1 = there are fewer within `farthest`.
double measured_step(std::int64_t squared, std::int64_t farthest) {
  const std::int64_t limit = farthest * farthest;
  return raster_step(static_cast<double>(squared < 0 ? limit : std::min(limit, squared)), kNeighbours);
}

// Thresholds of the places of one plane.
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
  // From the stations; false where none sees the plane there.
  bool predict(std::uint32_t i, float& reach) const {
    if (stations_.empty()) return false;
    const double step =
        kPlaneSteps * predicted_step(stations_, joined_.plane, position(frame_, places_.order.points[i]));
    if (!std::isfinite(step)) return false;
    reach = static_cast<float>(params_.gamma * std::min(step, measured_step(-1, places_.farthest[i])));
    return true;
  }

  // From the distance of the sixth neighbour.
  void measure(const std::vector<std::uint32_t>& queries, std::vector<float>& reach) const {
    std::int64_t farthest = 1;
    for (const std::uint32_t i : queries) farthest = std::max(farthest, places_.farthest[i]);
    std::vector<std::int64_t> squared(queries.size());
    kth_distances(place_cells(places_.order), queries, kNeighbours, farthest, squared);
    for (std::size_t q = 0; q < queries.size(); ++q)
      reach[queries[q]] = static_cast<float>(params_.gamma * measured_step(squared[q], places_.farthest[queries[q]]));
  }

  const PlanePlaces& places_;
  const BoundaryParams& params_;
  const JoinedPlane& joined_;
  PlaneFrame frame_;
  std::vector<Scanner> stations_;  // relative to the plane's anchor
};

template <class Wanted>
std::vector<std::uint32_t> positions_where(std::size_t count, const Wanted& wanted) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < count; ++i)
    if (wanted(i)) all.push_back(i);
  return all;
}

// What the triangles that a stretch owns are made of.
struct NeededPlaces {
  PlaneOrder order;  // its indices: points of the view
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

// What a stretch adds to its block.
struct OwnedEdges {
  std::vector<SeamEdge> edges;
  std::vector<Coincident> coincident;
  std::uint32_t regions = 0;
};

// The edges of triangles whose other side is not among them.
void add_edges(const Surroundings& around, std::uint32_t plane, const PlaneOrder& order, const Triangulation& t,
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
  std::vector<std::uint32_t> region(triangles.size(), kNoEdge);  // by root
  for (const std::uint32_t e : open) {
    const std::uint32_t a = t.corner[e], b = t.corner[next_edge(e)];
    std::uint32_t& r = region[joined.find(place[e / 3])];
    if (r == kNoEdge) r = out.regions++;
    out.edges.push_back({around.number(order.index[a]), around.number(order.index[b]), order.points[a], r, plane});
  }
}

OwnedEdges owned_edges(const Store& store, const Stretch& stretch, const BoundaryWork& work) {
  OwnedEdges out;
  const Surroundings around(store, stretch, work);
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

BoundaryWork boundary_work(const Store& store, const BoundaryParams& params, const PassContext& context) {
  constexpr std::uint64_t kLeast = std::uint64_t{1} << 14, kMost = std::uint64_t{1} << 18;
  const auto most = static_cast<std::uint32_t>(std::clamp(context.task_points / 8, kLeast, kMost));
  BoundaryWork work{params, 0, {0}, {}, {0}};
  double epsilon = 0;
  for (const JoinedPlane& p : params.planes) epsilon = std::max(epsilon, p.epsilon);
  work.across = static_cast<std::int64_t>(std::ceil(2 * epsilon)) + 2;  // and a unit for rounding
  std::vector<std::vector<Stretch>> cut(store.blocks().size());
  parallel_for(cut.size(),
               [&](std::size_t b) { cut[b] = cut_block(store, static_cast<std::uint32_t>(b), most, work.across); });
  for (std::size_t b = 0; b < cut.size(); ++b) {
    work.first.push_back(work.first.back() + store.blocks()[b].points);
    work.stretches.insert(work.stretches.end(), cut[b].begin(), cut[b].end());
    work.of_block.push_back(work.stretches.size());
  }
  return work;
}

PlaneFrame frame_of_joined(const JoinedPlane& plane) {
  return frame_of(plane.plane, {0, 0, 0});
}

std::uint64_t boundary_bytes(const Store& store, std::uint32_t block, const BoundaryWork& work) {
  std::uint64_t most = 0;
  IndexBox box;
  const std::span<const Stretch> all = work.of(block);
  for (const Stretch& s : all) most = std::max<std::uint64_t>(most, plan_surroundings(store, s, work, box).size);
  const auto together = std::min(all.size(), static_cast<std::size_t>(thread_count()));
  return together * most * kBytesPerPoint + store.blocks()[block].points * std::uint64_t{8};
}

void write_seam_edges(const Store& store, std::uint32_t block, const BoundaryWork& work) {
  const std::span<const Stretch> all = work.of(block);
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
  std::stable_sort(edges.begin(), edges.end(), [](const SeamEdge& a, const SeamEdge& b) { return a.plane < b.plane; });
  std::vector<SeamRun> runs;
  std::vector<std::uint32_t> number(regions, kNoEdge);  // of a region within its run
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (runs.empty() || runs.back().plane != edges[i].plane) runs.push_back({edges[i].plane, i});
    ++runs.back().count;
    std::uint32_t& n = number[edges[i].region];
    if (n == kNoEdge) n = runs.back().regions++;
    edges[i].region = n;
  }
  store.write<Coincident>(block, "coincident", coincident);
  store.write<SeamRun>(block, "seam_runs", runs);
  store.write<SeamEdge>(block, "seam_edges", edges);
}

}  // namespace ilot
