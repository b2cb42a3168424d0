// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/normals_pass.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/pass/pass.h"
#include "engine/store/flushed.h"
#include "engine/store/view.h"
#include "kernels/neighbours/normals.h"

namespace ilot {
namespace {

constexpr std::uint64_t kNormalBytesPerPoint = 112;  // per point of the block; twice as many points are read
constexpr std::uint64_t kLeastPoints = 1 << 15;      // a small block may have more points around it

// Points of one block, ascending, that need a halo of this margin.
struct Waiting {
  std::vector<std::uint32_t> points;
  std::int64_t margin = 0;
  bool unlimited = false;  // as many points as the limit coincide there: all are taken
};

std::int64_t root(std::int64_t squared) {
  auto r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squared)));
  while (r * r < squared) ++r;
  return r;
}

std::int64_t squared_distance(const ChunkBox& c, Index3 p) {
  const std::int64_t v[3]{p.x, p.y, p.z};
  std::int64_t sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t gap = std::max({std::int64_t{0}, std::int64_t{c.min[axis]} - v[axis], v[axis] - c.max[axis]});
    sum += gap * gap;
  }
  return sum;
}

// The squared distance to the k-th nearest point of the whole store, or max_d2 when it is farther. Chunks are read one
// at a time, the nearest first, so that a lonely point beside a dense surface costs no memory.
std::int64_t reach_by_chunks(const Store& store, Index3 p, const NormalsParams& params) {
  struct Chunk {
    std::int64_t d2;
    std::uint32_t block, first;
  };
  const std::int64_t radius = root(params.max_d2);
  std::vector<Chunk> chunks;
  for (const std::uint32_t block : store.blocks_in(IndexBox{p, p}.grown(radius))) {
    const Index3 c = corner(store.blocks()[block].node.tile);
    const auto boxes = store.read(block, columns::kChunks);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const std::int64_t d2 = squared_distance(boxes[i], {p.x - c.x, p.y - c.y, p.z - c.z});
      if (d2 <= params.max_d2) chunks.push_back({d2, block, i * kChunkPoints});
    }
  }
  std::sort(chunks.begin(), chunks.end(), [](const Chunk& a, const Chunk& b) { return a.d2 < b.d2; });
  std::vector<std::int64_t> nearest;  // a heap of the k smallest
  const std::size_t k = static_cast<std::size_t>(params.k);
  for (const Chunk& chunk : chunks) {
    if (nearest.size() == k && chunk.d2 > nearest.front()) break;
    const Block& b = store.blocks()[chunk.block];
    const auto codes =
        store.read(chunk.block, columns::kCodes, chunk.first, std::min(kChunkPoints, b.points - chunk.first));
    for (const std::uint64_t code : codes) {
      const Index3 q = index_of({b.node.tile, code});
      const std::int64_t dx = q.x - p.x, dy = q.y - p.y, dz = q.z - p.z;
      nearest.push_back(dx * dx + dy * dy + dz * dz);
      std::push_heap(nearest.begin(), nearest.end());
      if (nearest.size() <= k) continue;
      std::pop_heap(nearest.begin(), nearest.end());
      nearest.pop_back();
    }
  }
  return nearest.size() < k ? params.max_d2 : std::min(params.max_d2, nearest.front());
}

// The normals of one block. The first halo follows from the density of the block; points that need it get wider ones.
class BlockNormals {
 public:
  BlockNormals(const Store& store, std::uint32_t block, const NormalsParams& params)
      : store_(store),
        block_(block),
        params_(params),
        radius_(root(params.max_d2)),
        max_points_(2 * std::max<std::uint64_t>(kLeastPoints, store.blocks()[block].points)),
        result_(store.blocks()[block].points) {}

  std::vector<PackedNormal> compute() {
    Waiting all{std::vector<std::uint32_t>(result_.size()), first_margin(), false};
    std::iota(all.points.begin(), all.points.end(), 0u);
    std::vector<Waiting> stack{std::move(all)};
    while (!stack.empty()) {
      const Waiting group = std::move(stack.back());
      stack.pop_back();
      attempt(group, stack);
    }
    return std::move(result_);
  }

 private:
  // The reach that is enough for nearly all points, estimated from a sample of the block alone.
  std::int64_t first_margin() const {
    const Block& b = store_.blocks()[block_];
    View view = plan_view(store_, b.box, b.node.min_corner());
    std::erase_if(view.slices, [&](const Slice& s) { return s.block != block_; });
    view.slices.front().at = 0;
    view.size = b.points;
    load_points(store_, view);
    std::vector<std::uint32_t> sample;
    for (std::uint32_t i = 0; i < b.points; i += std::max<std::uint32_t>(1, b.points / 1024)) sample.push_back(i);
    std::vector<PackedNormal> unused(sample.size());
    std::vector<std::int64_t> reach2(sample.size());
    normals(build_neighbour_index(view.points()), sample, params_, unused, reach2);
    for (std::int64_t& r : reach2) r = r < 0 ? params_.max_d2 : r;
    std::sort(reach2.begin(), reach2.end());
    return std::min(radius_, root(reach2[reach2.size() * 98 / 100]) + 1);
  }

  // Finds the normals that are certain within the halo of the group, and puts the other points on the stack.
  void attempt(const Waiting& group, std::vector<Waiting>& stack) {
    const bool whole = group.points.size() == result_.size();
    const std::vector<IndexBox> boxes = whole ? std::vector{store_.blocks()[block_].box} : boxes_of(group.points);
    IndexBox read = IndexBox::none();
    for (const IndexBox& b : boxes) {
      read.add(b.min);
      read.add(b.max);
    }
    read = read.grown(group.margin);
    const auto is_near = [&](const IndexBox& chunk) {
      const IndexBox reach = chunk.grown(group.margin);
      return std::any_of(boxes.begin(), boxes.end(), [&](const IndexBox& b) { return b.intersects(reach); });
    };
    const Index3 anchor = store_.blocks()[block_].node.min_corner();
    View view = whole ? plan_view(store_, read, anchor) : plan_view(store_, read, anchor, is_near);
    if (view.size > max_points_ && !group.unlimited) return divide(group, stack);
    load_points(store_, view);
    const std::vector<std::uint32_t> queries = positions(view, group.points);
    std::vector<PackedNormal> found(queries.size());
    std::vector<std::int64_t> reach2(queries.size());
    normals(build_neighbour_index(view.points()), queries, params_, found, reach2);
    Waiting wider{{}, std::min(radius_, 2 * group.margin), false};
    for (std::size_t i = 0; i < queries.size(); ++i) {
      // Points farther than `clear` may not have been read. With fewer than k points, the result is certain only if all
      // of max_radius was read.
      const std::int64_t clear = whole ? clearance(read, view, queries[i]) : group.margin;
      const bool certain = reach2[i] < 0 ? clear >= radius_ : reach2[i] <= clear * clear;
      if (certain) {
        result_[group.points[i]] = found[i];
      } else {
        wider.points.push_back(group.points[i]);
      }
    }
    if (!wider.points.empty()) stack.push_back(std::move(wider));
  }

  // Divides a group that has too many points around it into two halves. A single point gets exactly the margin that it
  // needs.
  void divide(const Waiting& group, std::vector<Waiting>& stack) {
    if (group.points.size() == 1) {
      const Index3 p = position(group.points[0]);
      const std::int64_t reach = root(reach_by_chunks(store_, p, params_));
      stack.push_back({group.points, reach, true});
      return;
    }
    const auto middle = group.points.begin() + static_cast<std::ptrdiff_t>(group.points.size() / 2);
    stack.push_back({{group.points.begin(), middle}, group.margin, false});
    stack.push_back({{middle, group.points.end()}, group.margin, false});
  }

  Index3 position(std::uint32_t point) const {
    const auto code = store_.read(block_, columns::kCodes, point, 1);
    return index_of({store_.blocks()[block_].node.tile, code[0]});
  }

  // Boxes that contain the points, each around a few of them. Points that wait are mostly at the borders of the block,
  // so the box of all of them would be that of the block.
  std::vector<IndexBox> boxes_of(std::span<const std::uint32_t> points) const {
    constexpr std::uint32_t kApart = 256;                                         // a greater gap begins another box
    const std::size_t together = std::max<std::size_t>(16, points.size() / 256);  // points of a box
    const auto codes = store_.open(block_, columns::kCodes);
    const Tile tile = store_.blocks()[block_].node.tile;
    std::vector<std::uint64_t> around;
    std::vector<IndexBox> boxes;
    for (std::size_t i = 0, end = 0; i < points.size(); i = end) {
      for (end = i + 1; end < points.size() && end - i < together && points[end] - points[end - 1] <= kApart;) ++end;
      around.resize(points[end - 1] - points[i] + 1);
      codes.read(points[i], around);
      IndexBox& box = boxes.emplace_back(IndexBox::none());
      for (std::size_t k = i; k < end; ++k) box.add(index_of({tile, around[points[k] - points[i]]}));
    }
    return boxes;
  }

  static std::int64_t clearance(const IndexBox& box, const View& v, std::uint32_t i) {
    const Index3 p = v.position(i);
    return std::min(
        {p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y, p.z - box.min.z, box.max.z - p.z});
  }

  // The positions of points of the block in the view; both lists are ascending.
  std::vector<std::uint32_t> positions(const View& view, std::span<const std::uint32_t> points) const {
    std::vector<std::uint32_t> at;
    at.reserve(points.size());
    std::size_t i = 0;
    for (const Slice& s : view.slices) {
      if (s.block != block_) continue;
      for (; i < points.size() && points[i] < s.first + s.count; ++i) at.push_back(s.at + points[i] - s.first);
    }
    return at;
  }

  const Store& store_;
  std::uint32_t block_;
  NormalsParams params_;
  std::int64_t radius_;
  std::uint64_t max_points_;
  std::vector<PackedNormal> result_;
};

}  // namespace

void normals_pass(const Store& store, const NormalsSettings& settings, const PassContext& context) {
  const double units = std::floor(settings.max_radius / context.metres_per_unit / store.unit());
  const auto radius = static_cast<std::int64_t>(std::clamp(units, 1.0, 0x1p22));
  const NormalsParams params{settings.neighbours, radius * radius};
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks())
    tasks.push_back({std::max<std::uint64_t>(kLeastPoints, b.points) * kNormalBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, columns::kNormals)) {
      const auto result = BlockNormals(store, block, params).compute();
      store.write(block, columns::kNormals, result);
    }
    context.advance(store.blocks()[block].points);
  });
  flush_pass(store, Pass::normals);
}

}  // namespace ilot
