// SPDX-License-Identifier: Apache-2.0
#include "engine/store/view.h"

#include <algorithm>

namespace ilot {
namespace {

void append_slice(View& view, std::uint32_t block, std::uint32_t first, std::uint32_t count) {
  view.slices.push_back({block, first, count, static_cast<std::uint32_t>(view.size)});
  view.size += count;
}

using BoxTest = std::function<bool(const IndexBox&)>;

IndexBox box_of(const ChunkBox& c, Index3 tile_corner) {
  return {{tile_corner.x + c.min[0], tile_corner.y + c.min[1], tile_corner.z + c.min[2]},
          {tile_corner.x + c.max[0], tile_corner.y + c.max[1], tile_corner.z + c.max[2]}};
}

void plan_block(const Store& store, std::uint32_t block, const IndexBox& box, const BoxTest& wanted, View& view) {
  const Block& b = store.blocks()[block];
  if (wanted && !wanted(b.box)) return;
  if (!wanted && box.contains(b.box.min) && box.contains(b.box.max)) return append_slice(view, block, 0, b.points);
  const auto chunks = store.read(block, columns::kChunks);
  const Index3 tile_corner = corner(b.node.tile);
  for (std::uint32_t c = 0; c < chunks.size(); ++c) {
    const IndexBox chunk = box_of(chunks[c], tile_corner);
    if (!chunk.intersects(box) || (wanted && !wanted(chunk))) continue;
    const std::uint32_t first = c * kChunkPoints;
    const std::uint32_t count = std::min(kChunkPoints, b.points - first);
    const bool continues = !view.slices.empty() && view.slices.back().block == block &&
                           view.slices.back().first + view.slices.back().count == first;
    if (continues) {
      view.slices.back().count += count;
      view.size += count;
    } else {
      append_slice(view, block, first, count);
    }
  }
}

}  // namespace

View plan_view(const Store& store, const IndexBox& box, Index3 anchor) {
  return plan_view(store, box, anchor, {});
}

View plan_view(const Store& store, const IndexBox& box, Index3 anchor, const BoxTest& wanted) {
  View view;
  view.anchor = anchor;
  for (const std::uint32_t block : store.blocks_in(box)) plan_block(store, block, box, wanted, view);
  return view;
}

void load_points(const Store& store, View& view) {
  view.reset(view.size);
  std::vector<std::uint64_t> codes;
  for (const Slice& s : view.slices) {
    const auto reader = store.open(s.block, columns::kCodes);
    const Index3 c = corner(store.blocks()[s.block].node.tile);
    const Index3 from{c.x - view.anchor.x, c.y - view.anchor.y, c.z - view.anchor.z};
    constexpr std::uint32_t kBatch = 1 << 14;
    for (std::uint32_t done = 0; done < s.count; done += kBatch) {
      codes.resize(std::min(kBatch, s.count - done));
      reader.read(s.first + done, codes);
      for (std::size_t i = 0; i < codes.size(); ++i) {
        const Cell3 cell = morton_cell(codes[i]);
        const std::size_t at = s.at + done + i;
        view.x[at] = static_cast<float>(from.x + cell.x);
        view.y[at] = static_cast<float>(from.y + cell.y);
        view.z[at] = static_cast<float>(from.z + cell.z);
      }
    }
  }
}

PointRange range_of_block(const View& view, std::uint32_t block) {
  PointRange range;
  bool found = false;
  for (const Slice& s : view.slices) {
    if (s.block != block) continue;
    if (!found) range.begin = s.at;
    range.end = s.at + s.count;
    found = true;
  }
  return range;
}

}  // namespace ilot
