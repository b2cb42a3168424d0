// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/label_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/pass/pass.h"
#include "engine/segments/block_cells.h"
#include "kernels/core/rng.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/normals.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 72;
constexpr int kVoters = 13;                 // the point itself and its 12 nearest
constexpr int kLeastVotes = 2;              // for a plane to be a candidate
constexpr int kIslandOwnVotes = 2;          // at most so many neighbours share the label of an island
constexpr int kIslandOtherVotes = 8;        // and at least so many agree on another
constexpr double kFlat = 1.6;               // curvature of pure noise with twice its deviation, over (noise / step)^2
constexpr double kPartedByNormals = 0.996;  // cosine of 5 degrees: planes that normals can tell apart
constexpr double kStrictly = 1 - 1e-6;      // rounding of coordinates and of float32 stays within epsilon

struct StoredTally {
  std::uint32_t plane = 0;
  PlaneTally tally;
};

struct Vote {
  std::uint32_t plane = 0;
  int count = 0;
};

// Planes of the neighbours, the point itself left out, in the order of the neighbours.
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
              const JoinedPlanes& joined, const PassContext& context)
      : store_(store), block_(block), cells_(cells), cell_planes_(cell_planes), joined_(joined), context_(context) {
    const Block& b = store.blocks()[block];
    view_ = load_view(store, b.box.grown(cells.widest_connectivity), b.node.min_corner());
    before_ = load_column<std::uint32_t>(store, view_, "segment");
    for (std::uint32_t& s : before_) s = s == 0 ? 0 : joined.of_segment[s - 1];
    normals_ = load_column<PackedNormal>(store, view_, "normals");
    own_ = range_of_block(view_, block);
    plane_.resize(b.points);
  }

  void decide() {
    const NeighbourIndex index = build_neighbour_index(view_.points());
    constexpr std::uint32_t kBatch = 256;
    std::vector<std::uint32_t> queries, neighbours(kBatch * kVoters);
    std::vector<std::int64_t> reach2(kBatch);
    for (const BlockCells::Range& range : cells_.ranges) {
      const CellSummary& cell = cell_planes_.cells[range.cell];
      const std::int64_t r = cell.connectivity;
      flat_ = cell.step > 0 ? kFlat * (cell.noise / cell.step) * (cell.noise / cell.step) : 0;
      for (std::uint32_t done = 0; done < range.count; done += kBatch) {
        const std::uint32_t n = std::min(kBatch, range.count - done);
        queries.clear();
        for (std::uint32_t i = 0; i < n; ++i) queries.push_back(own_.begin + range.first + done + i);
        const auto lists = std::span(neighbours).first(std::size_t{n} * kVoters);
        knn(index, queries, {kVoters, r * r}, lists, std::span(reach2).first(n));
        for (std::uint32_t i = 0; i < n; ++i)
          set(range.first + done + i, choose(queries[i], lists.subspan(std::size_t{i} * kVoters, kVoters)));
      }
    }
  }

  std::vector<StoredTally> tallies() const {
    std::map<std::uint32_t, PlaneTally> by_plane;
    const auto codes = store_.read<std::uint64_t>(block_, "codes");
    for (std::uint32_t i = 0; i < plane_.size(); ++i) {
      if (plane_[i] == 0) continue;
      PlaneTally& t = by_plane[plane_[i]];
      const Index3 p = view_.position(own_.begin + i);
      const Index3 anchor = joined_.planes[plane_[i] - 1].anchor;
      t.moments.add_point({p.x - anchor.x, p.y - anchor.y, p.z - anchor.z});
      t.content_id += mix64(codes[i]);
      t.box.min = {std::min(t.box.min.x, p.x), std::min(t.box.min.y, p.y), std::min(t.box.min.z, p.z)};
      t.box.max = {std::max(t.box.max.x, p.x), std::max(t.box.max.y, p.y), std::max(t.box.max.z, p.z)};
    }
    std::vector<StoredTally> list;
    for (const auto& [plane, tally] : by_plane) list.push_back({plane, tally});
    return list;
  }

  void write() const {
    store_.write<StoredTally>(block_, "tally", tallies());
    store_.write<std::uint32_t>(block_, "plane", plane_);
  }

 private:
  double distance(std::uint32_t i, std::uint32_t plane) const {
    const JoinedPlane& j = joined_.planes[plane - 1];
    const Index3 p = view_.position(i);
    return signed_distance(j.plane, {static_cast<double>(p.x - j.anchor.x), static_cast<double>(p.y - j.anchor.y),
                                     static_cast<double>(p.z - j.anchor.z)});
  }

  bool within(std::uint32_t i, std::uint32_t plane) const {
    return std::abs(distance(i, plane)) <= joined_.planes[plane - 1].epsilon * kStrictly - context_.rounding;
  }

  std::uint32_t choose(std::uint32_t i, std::span<const std::uint32_t> neighbours) const {
    std::array<Vote, kVoters> votes;
    const int kinds = count_votes(neighbours, i, before_, votes);
    const std::uint32_t own = before_[i];
    int own_votes = 0;
    for (int v = 0; v < kinds; ++v)
      if (votes[static_cast<std::size_t>(v)].plane == own) own_votes = votes[static_cast<std::size_t>(v)].count;
    std::uint32_t best = own != 0 && within(i, own) ? own : 0;
    for (int v = 0; v < kinds; ++v) {
      const Vote& vote = votes[static_cast<std::size_t>(v)];
      if (vote.plane == own || vote.count < kLeastVotes || !within(i, vote.plane)) continue;
      if (own_votes <= kIslandOwnVotes && vote.count >= kIslandOtherVotes) return vote.plane;
      if (best == 0 || beyond(i, best, vote.plane, neighbours)) best = vote.plane;
    }
    return best;
  }

  // Of two planes that a point is within epsilon of, does it belong to b rather than a? Away from edges (all is flat
  // around the point: the planes cross inside one of the faces) its normal decides. At an edge normals are mixtures,
  // and the bisector of the planes decides that parts the neighbours: a ridge, a valley or a step. The nearer plane
  // would not do: a point that noise lifts above a ridge is nearer to the face on the other side.
  bool beyond(std::uint32_t i, std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> neighbours) const {
    if (is_flat(i) && std::abs(dot(joined_.planes[a - 1].plane.n, joined_.planes[b - 1].plane.n)) < kPartedByNormals)
      return agreement(i, b) > agreement(i, a);
    return beyond_bisector(i, a, b, neighbours);
  }

  bool is_flat(std::uint32_t i) const {
    constexpr double kGreatest = 3.0 * 65535;
    return normals_[i].curvature <= flat_ * kGreatest;
  }

  bool beyond_bisector(std::uint32_t i, std::uint32_t a, std::uint32_t b,
                       std::span<const std::uint32_t> neighbours) const {
    struct Seen {
      double from_a, from_b;
      bool on_b;
    };
    std::array<Seen, kVoters> seen;
    std::size_t count = 0;
    double side_of_a = 0, side_of_b = 0;  // where points of a lie from b, and of b from a
    for (const std::uint32_t j : neighbours) {
      if (j == kNoNeighbour) break;
      if (before_[j] != a && before_[j] != b) continue;
      const Seen s{distance(j, a), distance(j, b), before_[j] == b};
      (s.on_b ? side_of_b : side_of_a) += s.on_b ? s.from_a : s.from_b;
      seen[count++] = s;
    }
    const bool same = (side_of_a > 0) == (side_of_b > 0);
    const auto on_side_of_b = [&](double from_a, double from_b) {
      return ((same ? from_b - from_a : from_a + from_b) > 0) != (side_of_a > 0);
    };
    std::size_t right = 0;
    for (std::size_t n = 0; n < count; ++n) right += on_side_of_b(seen[n].from_a, seen[n].from_b) == seen[n].on_b;
    if (4 * right >= 3 * count) return on_side_of_b(distance(i, a), distance(i, b));
    return agreement(i, b) > agreement(i, a);
  }

  double agreement(std::uint32_t i, std::uint32_t plane) const {
    const PackedNormal& n = normals_[i];
    const Vec3 normal{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    return std::abs(dot(normal, joined_.planes[plane - 1].plane.n));
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
  View view_;
  PointRange own_;
  std::vector<std::uint32_t> before_;  // joined plane per point of the view, as the cells found them
  std::vector<PackedNormal> normals_;
  double flat_ = 0;                   // curvature up to which a neighbourhood of the cell at hand is flat
  std::vector<std::uint32_t> plane_;  // of the block's own points
};

void add(PlaneTally& sum, const PlaneTally& t) {
  sum.moments.add(t.moments);
  sum.content_id += t.content_id;
  sum.box.min = {std::min(sum.box.min.x, t.box.min.x), std::min(sum.box.min.y, t.box.min.y),
                 std::min(sum.box.min.z, t.box.min.z)};
  sum.box.max = {std::max(sum.box.max.x, t.box.max.x), std::max(sum.box.max.y, t.box.max.y),
                 std::max(sum.box.max.z, t.box.max.z)};
}

}  // namespace

std::vector<PlaneTally> label_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                                   const JoinedPlanes& joined, const PassContext& context) {
  const std::vector<BlockCells> block_cells = cells_of_blocks(store, cells, cell_planes);
  std::vector<PassTask> tasks;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    tasks.push_back({points_around(store, b, block_cells[b]) * kBytesPerPoint, store.blocks()[b].points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, "plane")) {
      BlockLabels labels(store, block, block_cells[block], cell_planes, joined, context);
      labels.decide();
      labels.write();
    }
    context.advance(store.blocks()[block].points - store.blocks()[block].points / 2);
  });
  std::vector<PlaneTally> tallies(joined.planes.size());
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block)
    for (const StoredTally& t : read_column<StoredTally>(store.path(block, "tally")))
      add(tallies[t.plane - 1], t.tally);
  return tallies;
}

}  // namespace ilot
