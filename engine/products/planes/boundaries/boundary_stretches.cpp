// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/boundaries/boundary_stretches.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/units/unit_stretches.h"
#include "kernels/core/parallel.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {
namespace {

// The bytes for a stretch with its surroundings, and for the places of these that are triangulated: mostly far fewer
// than four times the points of the stretch.
constexpr std::uint64_t kBytesPerPoint = 72, kBytesPerCorner = 208;
constexpr std::uint64_t kCornersPerPoint = 4;

IndexBox common(const IndexBox& a, const IndexBox& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}

// Cells are cut until they are small enough. A compact cell has few points around it.
struct Cutter {
  std::uint32_t number, most;
  std::span<const std::uint64_t> codes;
  IndexBox box;  // box around the points of the block
  std::vector<BoundaryStretch> out;

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

std::vector<BoundaryStretch> cut_block(const Store& store, std::uint32_t block, std::uint32_t most,
                                       std::int64_t across) {
  const auto codes = store.read(block, columns::kCodes);
  const Block& b = store.blocks()[block];
  Cutter cutter{block, most, codes, b.box.grown(across), {}};
  cutter.cut(b.node, 0, b.points);
  return std::move(cutter.out);
}

// Whether some stretch contains this place.
bool is_held(const BoundaryWork& work, Index3 place) {
  const PointKey key = key_of(place);
  const auto after = std::upper_bound(work.stretches.begin(), work.stretches.end(), key,
                                      [](const PointKey& k, const BoundaryStretch& s) {
                                        return k < PointKey{s.node.tile, s.node.first_code};
                                      });
  return after != work.stretches.begin() && std::prev(after)->box.contains(place);
}

// The length in steps of a frame, with the largest value that the search for neighbours accepts.
std::int64_t in_steps(std::int64_t units) {
  return std::min(std::int64_t{1} << 22, units * static_cast<std::int64_t>(kPlaneSteps));
}

// The largest range in a run of points of a block.
std::int64_t farthest_of(std::span<const NeighbourRange> ranges, std::uint32_t first, std::uint32_t count) {
  std::int64_t farthest = 1;
  for (const NeighbourRange& r : ranges)
    if (r.first < first + count && first < r.first + r.count) farthest = std::max(farthest, r.farthest);
  return farthest;
}

// The view of the points that a stretch needs: all that the circles of its triangles reach, and the neighbours of these
// points.
View plan_surroundings(const Store& store, const BoundaryStretch& s, const BoundaryWork& work, IndexBox& box) {
  const auto& ranges = work.params.ranges;
  const Index3 anchor = store.blocks()[s.block].node.min_corner();
  std::int64_t farthest_own = 1;
  for (const Slice& slice : plan_view(store, s.box.grown(work.across), anchor).slices)
    farthest_own = std::max(farthest_own, farthest_of(ranges[slice.block], slice.first, slice.count));
  const double own = static_cast<double>(in_steps(farthest_own));
  const double largest = work.params.threshold > 0 ? work.params.threshold * kPlaneSteps
                                                   : work.params.gamma * raster_step(own * own, kStepNeighbours);
  const std::int64_t circles =
      shape_halo(work.params.rule, largest) / static_cast<std::int64_t>(kPlaneSteps) + work.across;
  std::int64_t farthest = 1;
  for (const Slice& slice : plan_view(store, s.box.grown(circles + work.across), anchor).slices)
    farthest = std::max(farthest, farthest_of(ranges[slice.block], slice.first, slice.count));
  box = s.box.grown(circles + farthest + 2 * work.across);
  return plan_view(store, box, anchor);
}

}  // namespace

BoundaryWork boundary_work(const Store& store, const BoundaryParams& params, const PassContext& context) {
  constexpr std::uint64_t kLeast = std::uint64_t{1} << 14, kMost = std::uint64_t{1} << 18;
  const auto most = static_cast<std::uint32_t>(std::clamp(context.task_points / 8, kLeast, kMost));
  BoundaryWork work{params, 0, {0}, {}, {0}};
  double epsilon = 0;
  for (const JoinedPlane& p : params.planes) epsilon = std::max(epsilon, p.epsilon);
  work.across = static_cast<std::int64_t>(std::ceil(2 * epsilon)) + 2;  // plus one unit for rounding
  std::vector<std::vector<BoundaryStretch>> cut(store.blocks().size());
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * sizeof(std::uint64_t), b.points});
  run_pass(tasks, context.budget_bytes,
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
  const std::span<const BoundaryStretch> all = work.of(block);
  for (const BoundaryStretch& s : all) {
    const std::uint64_t around = plan_surroundings(store, s, work, box).size;
    const std::uint64_t corners = std::min(around, kCornersPerPoint * s.count);
    most = std::max(most, around * kBytesPerPoint + corners * kBytesPerCorner);
  }
  const auto together = std::min(all.size(), static_cast<std::size_t>(thread_count()));
  return together * most + store.blocks()[block].points * std::uint64_t{8};
}

BoundarySurroundings::BoundarySurroundings(const Store& store, const BoundaryStretch& stretch, const BoundaryWork& work)
    : work_(work),
      stretch_(stretch),
      anchor_(store.blocks()[stretch.block].node.min_corner()),
      first_own_(work.first[stretch.block] + stretch.first) {
  find_planes(store);
  IndexBox box;
  const View plan = plan_surroundings(store, stretch, work, box);
  load(store, plan, box);
}

void BoundarySurroundings::find_planes(const Store& store) {
  const IndexBox near = stretch_.box.grown(work_.across);
  for_each_stretch_in(store, near, [&](const Stretch& s, std::span<const StretchPoint> inside) {
    const auto segments = s.read(store, columns::kPlane);
    for (const StretchPoint& p : inside) {
      const std::uint32_t plane = work_.params.final_id[segments[p.number]];
      if (plane != 0 && (planes_.empty() || planes_.back() != plane)) planes_.push_back(plane);
    }
  });
  std::sort(planes_.begin(), planes_.end());
  planes_.erase(std::unique(planes_.begin(), planes_.end()), planes_.end());
}

void BoundarySurroundings::load(const Store& store, const View& plan, const IndexBox& box) {
  std::uint32_t last = 0;
  bool wanted = false;
  for_each_stretch(store, plan.slices, [&](const Stretch& s) {
    const auto segments = s.read(store, columns::kPlane);
    const std::vector<NeighbourRange>& ranges = work_.params.ranges[s.block];
    std::size_t range = 0;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      const std::uint32_t plane = work_.params.final_id[segments[i]], point = s.first + i;
      if (plane == 0) continue;
      if (plane != last) wanted = std::binary_search(planes_.begin(), planes_.end(), plane);
      last = plane;
      if (!wanted) continue;
      const Index3 p = s.position(i);
      if (!box.contains(p)) continue;
      while (point >= ranges[range].first + ranges[range].count) ++range;
      points_.push_back({work_.first[s.block] + point, static_cast<float>(p.x - anchor_.x),
                         static_cast<float>(p.y - anchor_.y), static_cast<float>(p.z - anchor_.z), plane,
                         in_steps(ranges[range].farthest)});
    }
  });
}

std::vector<std::int32_t> BoundarySurroundings::heights(std::uint32_t plane,
                                                        std::span<const std::uint32_t> points) const {
  const JoinedPlane& joined = work_.params.planes[plane - 1];
  std::vector<std::int32_t> heights;
  for (const std::uint32_t i : points)
    heights.push_back(static_cast<std::int32_t>(
        std::floor(kPlaneSteps * signed_distance(joined.plane, from_anchor(joined, i)) + 0.5)));
  return heights;
}

void BoundarySurroundings::each_plane(const std::function<void(const PlanePlaces&)>& use) const {
  std::vector<std::vector<std::uint32_t>> members(planes_.size());
  std::uint32_t last = 0;
  std::vector<std::uint32_t>* of_last = nullptr;
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    if (of_last == nullptr || points_[i].plane != last) {
      last = points_[i].plane;
      of_last =
          &members[static_cast<std::size_t>(std::lower_bound(planes_.begin(), planes_.end(), last) - planes_.begin())];
    }
    of_last->push_back(i);
  }
  for (std::size_t p = 0; p < planes_.size(); ++p)
    if (!members[p].empty()) use(placed(planes_[p], std::exchange(members[p], {})));
}

// A point belongs to the stretch that contains its foot, or the point itself if no stretch contains the foot.
bool BoundarySurroundings::is_own(std::uint32_t i, Index3 foot) const {
  if (stretch_.box.contains(foot)) return true;
  return is_inside(i) && !is_held(work_, foot);
}

PlanePlaces BoundarySurroundings::placed(std::uint32_t plane, const std::vector<std::uint32_t>& members) const {
  const JoinedPlane& joined = work_.params.planes[plane - 1];
  const PlaneFrame frame = frame_of_joined(joined);
  std::vector<Point2> places;
  places.reserve(members.size());
  for (const std::uint32_t i : members) places.push_back(project(frame, from_anchor(joined, i)));
  PlanePlaces out{plane, plane_order(places), {}, {}};
  for (std::size_t at = 0; at < out.order.index.size(); ++at) {
    std::uint32_t& i = out.order.index[at];
    i = members[i];
    out.farthest.push_back(points_[i].farthest);
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

Vec3 BoundarySurroundings::from_anchor(const JoinedPlane& joined, std::uint32_t i) const {
  const Index3 p = position_of(i);
  return {static_cast<double>(p.x - joined.anchor.x), static_cast<double>(p.y - joined.anchor.y),
          static_cast<double>(p.z - joined.anchor.z)};
}

}  // namespace ilot
