// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/label_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/pass/pass.h"
#include "engine/products/planes/cells/block_cells.h"
#include "engine/products/planes/join/extend_pass.h"
#include "engine/store/flushed.h"
#include "engine/store/sorted_columns.h"
#include "kernels/core/rng.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals.h"

namespace ilot {

struct StoredPlaneTally {
  std::uint32_t plane = 0;
  PlaneTally tally;
};

namespace {

constexpr std::uint64_t kLabelBytesPerPoint = 72;
constexpr int kVoters = 13;     // the point itself and its 12 nearest neighbours
constexpr int kLeastVotes = 2;  // votes that make a plane a candidate
// Choice: planes.normal_angle at its most.
constexpr double kAgreeing2 = 0.8213938048432696;  // squared cosine of 25 degrees
// Derived: above the rounding of float32.
constexpr double kStrictly = 1 - 1e-6;  // so that rounding of coordinates and to float32 stays within epsilon

struct Vote {
  std::uint32_t plane = 0;
  int count = 0;
};

// Counts the planes of the neighbours without the point itself, in the order of the neighbours.
int count_votes(std::span<const std::uint32_t> neighbours, std::uint32_t self, const std::vector<std::uint32_t>& plane,
                std::array<Vote, kVoters>& votes) {
  int kinds = 0;
  for (const std::uint32_t j : neighbours) {
    if (j == kNoNeighbour) break;
    if (j == self || plane[j] == 0) continue;
    int v = 0;
    while (v < kinds && votes[static_cast<std::size_t>(v)].plane != plane[j]) ++v;
    if (v == kinds) votes[static_cast<std::size_t>(kinds++)] = {plane[j], 0};
    ++votes[static_cast<std::size_t>(v)].count;
  }
  return kinds;
}

class BlockLabels {
 public:
  BlockLabels(const Store& store, std::uint32_t block, const BlockCells& cells, const CellPlanes& cell_planes,
              const JoinedPlanes& joined, const PassContext& context, const ColourPalette& palette)
      : store_(store),
        block_(block),
        cells_(cells),
        cell_planes_(cell_planes),
        joined_(joined),
        context_(context),
        palette_(palette) {
    const Block& b = store.blocks()[block];
    view_ = load_view(store, b.box.grown(cells.widest_connectivity), b.node.min_corner());
    before_.resize(view_.size);
    for (const Slice& s : view_.slices)
      read_extended(store, joined, s.block, s.first, std::span(before_).subspan(s.at, s.count));
    for (std::uint32_t& plane : before_)
      if (plane != 0 && joined.planes[plane - 1].too_small) plane = 0;
    own_ = range_of_block(view_, block);
    plane_.resize(b.points);
  }

  void decide() {
    const NeighbourIndex index = build_neighbour_index(view_.points());
    for (const BlockCells::Range& range : cells_.ranges) {
      std::vector<std::uint32_t> strays;
      for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
        const std::uint32_t own = before_[own_.begin + i];
        if (own != 0 && within(own_.begin + i, own)) {
          set(i, own);
        } else {
          strays.push_back(own_.begin + i);
        }
      }
      label_strays(strays, index, cell_planes_.cells[range.cell].connectivity);
    }
  }

  std::vector<StoredPlaneTally> tallies() const {
    std::map<std::uint32_t, PlaneTally> by_plane;
    const auto codes = store_.read(block_, columns::kCodes);
    const auto normals = store_.read(block_, columns::kNormals);
    std::uint32_t last = 0;  // neighbours in the list mostly have the same plane
    PlaneTally* of_last = nullptr;
    PlaneFrame frame;
    for (std::uint32_t i = 0; i < plane_.size(); ++i) {
      if (plane_[i] == 0) continue;
      if (of_last == nullptr || plane_[i] != last) {
        last = plane_[i];
        of_last = &by_plane[last];
        frame = frame_of(joined_.planes[last - 1].plane, {});
      }
      PlaneTally& t = *of_last;
      const Index3 p = view_.position(own_.begin + i);
      const Index3 anchor = joined_.planes[last - 1].anchor;
      const Index3 from_anchor{p.x - anchor.x, p.y - anchor.y, p.z - anchor.z};
      t.moments.add_point(from_anchor);
      t.content_id += mix64(codes[i]);
      add_extent(frame, from_anchor, t);
      add_normal(i, last, normals[i], t);
      t.box.min = {std::min(t.box.min.x, p.x), std::min(t.box.min.y, p.y), std::min(t.box.min.z, p.z)};
      t.box.max = {std::max(t.box.max.x, p.x), std::max(t.box.max.y, p.y), std::max(t.box.max.z, p.z)};
    }
    add_colours(by_plane);
    std::vector<StoredPlaneTally> list;
    for (const auto& [plane, tally] : by_plane) list.push_back({plane, tally});
    return list;
  }

  void write() const {
    store_.write(block_, columns::kTally, tallies());
    store_.write(block_, columns::kPlane, plane_);
  }

 private:
  // Labels the points (of the view, ascending) that do not keep the plane of their cell.
  void label_strays(std::span<const std::uint32_t> strays, const NeighbourIndex& index, std::int64_t reach) {
    constexpr std::size_t kBatch = 256;
    std::vector<std::uint32_t> neighbours(kBatch * kVoters);
    std::vector<std::int64_t> reach2(kBatch);
    for (std::size_t done = 0; done < strays.size(); done += kBatch) {
      const auto batch = strays.subspan(done, std::min(kBatch, strays.size() - done));
      const auto lists = std::span(neighbours).first(batch.size() * kVoters);
      knn(index, batch, {kVoters, reach * reach}, lists, std::span(reach2).first(batch.size()));
      for (std::size_t i = 0; i < batch.size(); ++i)
        set(batch[i] - own_.begin, nearest(batch[i], lists.subspan(i * kVoters, kVoters)));
    }
  }

  double distance(std::uint32_t i, std::uint32_t plane) const {
    const JoinedPlane& j = joined_.planes[plane - 1];
    const Index3 p = view_.position(i);
    return signed_distance(j.plane, {static_cast<double>(p.x - j.anchor.x), static_cast<double>(p.y - j.anchor.y),
                                     static_cast<double>(p.z - j.anchor.z)});
  }

  void add_colours(std::map<std::uint32_t, PlaneTally>& by_plane) const {
    if (palette_.centre.empty()) return;
    const auto colours = store_.read(block_, columns::kColour);
    for (std::size_t i = 0; i < plane_.size(); ++i) {
      const std::uint32_t c = plane_[i] == 0 ? 0 : palette_.class_of(colours[i]);
      if (c != 0) ++by_plane[plane_[i]].colours[c - 1];
    }
  }

  static void add_extent(const PlaneFrame& frame, Index3 from_anchor, PlaneTally& t) {
    const Vec3 v{static_cast<double>(from_anchor.x), static_cast<double>(from_anchor.y),
                 static_cast<double>(from_anchor.z)};
    const double along[2]{dot(v, frame.u), dot(v, frame.v)};
    for (int axis = 0; axis < 2; ++axis) {
      t.low[axis] = std::min(t.low[axis], along[axis]);
      t.high[axis] = std::max(t.high[axis], along[axis]);
    }
  }

  void add_normal(std::uint32_t point, std::uint32_t plane, const PackedNormal& packed, PlaneTally& t) const {
    const Vec3 normal{static_cast<double>(packed.x), static_cast<double>(packed.y), static_cast<double>(packed.z)};
    const double length2 = dot(normal, normal);
    if (length2 == 0) return;
    const JoinedPlane& j = joined_.planes[plane - 1];
    const double across = dot(normal, j.plane.n);
    const double cos2 = std::min(1.0, across * across / length2);
    ++t.with_normal;
    t.squared_sines += static_cast<std::uint64_t>((1 - cos2) / kSineUnit);
    t.sure += cos2 >= kAgreeing2 && std::abs(distance(own_.begin + point, plane)) <= j.epsilon / 2;
  }

  bool within(std::uint32_t i, std::uint32_t plane) const {
    return std::abs(distance(i, plane)) <= joined_.planes[plane - 1].epsilon * kStrictly - context_.rounding;
  }

  // The nearest of the planes that enough neighbours have. In a tie it is the plane that comes first, which is that of
  // the nearer neighbour.
  std::uint32_t nearest(std::uint32_t i, std::span<const std::uint32_t> neighbours) const {
    std::array<Vote, kVoters> votes;
    const int kinds = count_votes(neighbours, i, before_, votes);
    std::uint32_t best = 0;
    double least = 0;
    for (int v = 0; v < kinds; ++v) {
      const Vote& vote = votes[static_cast<std::size_t>(v)];
      if (vote.count < kLeastVotes || !within(i, vote.plane)) continue;
      const double d = std::abs(distance(i, vote.plane));
      if (best != 0 && d >= least) continue;
      best = vote.plane;
      least = d;
    }
    return best;
  }

  void set(std::uint32_t point, std::uint32_t plane) {
    const bool wanted = !context_.wanted || context_.wanted(view_.position(own_.begin + point));
    plane_[point] = wanted ? plane : 0;
  }

  const Store& store_;
  std::uint32_t block_;
  const BlockCells& cells_;
  const CellPlanes& cell_planes_;
  const JoinedPlanes& joined_;
  const PassContext& context_;
  const ColourPalette& palette_;
  View view_;
  PointRange own_;
  std::vector<std::uint32_t> before_;  // joined plane of each point of the view, as found by the cells
  std::vector<std::uint32_t> plane_;   // joined plane of each own point of the block
};

void add(PlaneTally& sum, const PlaneTally& t) {
  sum.moments.add(t.moments);
  sum.content_id += t.content_id;
  sum.sure += t.sure;
  sum.with_normal += t.with_normal;
  sum.squared_sines += t.squared_sines;
  for (std::size_t c = 0; c < sum.colours.size(); ++c) sum.colours[c] += t.colours[c];
  for (int axis = 0; axis < 2; ++axis) {
    sum.low[axis] = std::min(sum.low[axis], t.low[axis]);
    sum.high[axis] = std::max(sum.high[axis], t.high[axis]);
  }
  sum.box.min = {std::min(sum.box.min.x, t.box.min.x), std::min(sum.box.min.y, t.box.min.y),
                 std::min(sum.box.min.z, t.box.min.z)};
  sum.box.max = {std::max(sum.box.max.x, t.box.max.x), std::max(sum.box.max.y, t.box.max.y),
                 std::max(sum.box.max.z, t.box.max.z)};
}

}  // namespace

void label_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                const JoinedPlanes& joined, const PassContext& context, const ColourPalette& palette) {
  const std::vector<BlockCells> block_cells = cells_of_blocks(store, cells, cell_planes);
  std::vector<PassTask> tasks;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    tasks.push_back({points_around(store, b, block_cells[b]) * kLabelBytesPerPoint, store.blocks()[b].points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, columns::kPlane)) {
      BlockLabels labels(store, block, block_cells[block], cell_planes, joined, context, palette);
      labels.decide();
      labels.write();
    }
    context.advance(store.blocks()[block].points - store.blocks()[block].points / 2);
  });
  flush_pass(store, Pass::labels);
}

void each_tally(const Store& store, std::size_t planes,
                const std::function<void(std::size_t plane, const PlaneTally& tally)>& take) {
  constexpr std::size_t kPlanesTogether = 256;  // of 400 bytes each, from each block in which they have points
  SortedColumns parts(store, columns::kTally, [](const StoredPlaneTally& t) { return std::uint64_t{t.plane}; });
  std::vector<PlaneTally> sums;
  for (std::size_t first = 0; first < planes; first += kPlanesTogether) {
    sums.assign(std::min(kPlanesTogether, planes - first), {});
    for (const StoredPlaneTally& t : parts.until(first + sums.size() + 1)) add(sums[t.plane - 1 - first], t.tally);
    for (std::size_t i = 0; i < sums.size(); ++i) take(first + i, sums[i]);
  }
}

}  // namespace ilot
