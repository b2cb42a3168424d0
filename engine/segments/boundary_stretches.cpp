// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/boundary_stretches.h"

#include <algorithm>
#include <cmath>

#include "engine/pass/pass.h"
#include "kernels/core/parallel.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/sampling_step.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 280;  // of a stretch and its surroundings: the triangulation

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
  const auto codes = store.read(block, columns::kCodes);
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
  work.across = static_cast<std::int64_t>(std::ceil(2 * epsilon)) + 2;  // and a unit for rounding
  std::vector<std::vector<Stretch>> cut(store.blocks().size());
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
  const std::span<const Stretch> all = work.of(block);
  for (const Stretch& s : all) most = std::max<std::uint64_t>(most, plan_surroundings(store, s, work, box).size);
  const auto together = std::min(all.size(), static_cast<std::size_t>(thread_count()));
  return together * most * kBytesPerPoint + store.blocks()[block].points * std::uint64_t{8};
}

Surroundings::Surroundings(const Store& store, const Stretch& stretch, const BoundaryWork& work)
    : work_(work), stretch_(stretch) {
  IndexBox box;
  view_ = plan_surroundings(store, stretch, work, box);
  load_points(store, view_);
  plane_ = load_column(store, view_, columns::kPlane);
  for (std::uint32_t i = 0; i < plane_.size(); ++i)
    plane_[i] = box.contains(view_.position(i)) ? work.params.final_id[plane_[i]] : 0;
  for (const Slice& s : view_.slices)
    if (s.block == stretch.block && s.first <= stretch.first && stretch.first < s.first + s.count)
      own_ = s.at + (stretch.first - s.first);
  own_end_ = own_ + stretch.count;
}

std::uint64_t Surroundings::number(std::uint32_t i) const {
  const Slice& s = *std::prev(std::upper_bound(view_.slices.begin(), view_.slices.end(), i,
                                               [](std::uint32_t at, const Slice& t) { return at < t.at; }));
  return work_.first[s.block] + s.first + (i - s.at);
}

std::vector<std::int32_t> Surroundings::heights(std::uint32_t plane, std::span<const std::uint32_t> points) const {
  const JoinedPlane& joined = work_.params.planes[plane - 1];
  std::vector<std::int32_t> heights;
  for (const std::uint32_t i : points)
    heights.push_back(static_cast<std::int32_t>(
        std::floor(kPlaneSteps * signed_distance(joined.plane, from_anchor(joined, i)) + 0.5)));
  return heights;
}

void Surroundings::each_plane(const std::function<void(const PlanePlaces&)>& use) const {
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

// By where the foot lies; by the point itself where no stretch holds the foot.
bool Surroundings::is_own(std::uint32_t i, Index3 foot) const {
  if (stretch_.box.contains(foot)) return true;
  return is_inside(i) && !is_held(work_, foot);
}

PlanePlaces Surroundings::placed(std::uint32_t plane, const std::vector<std::uint32_t>& members) const {
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

Vec3 Surroundings::from_anchor(const JoinedPlane& joined, std::uint32_t i) const {
  const Index3 p = view_.position(i);
  return {static_cast<double>(p.x - joined.anchor.x), static_cast<double>(p.y - joined.anchor.y),
          static_cast<double>(p.z - joined.anchor.z)};
}

std::vector<std::int64_t> Surroundings::farthest_of_members(const std::vector<std::uint32_t>& members) const {
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

}  // namespace ilot
