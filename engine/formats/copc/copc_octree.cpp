// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/copc/copc_octree.h"

#include <algorithm>
#include <span>

namespace ilot {
namespace {

int shift_of(int level) {
  return 3 * (kMortonBits - level);
}

// Returns the square of twice the distance from the centre of a cell of 2^bits along each edge, in the smallest cells.
std::uint64_t off_centre(std::uint64_t code, int bits) {
  const Cell3 cell = morton_cell(code);
  const std::int64_t side = std::int64_t{1} << bits;
  const auto square = [side](std::uint32_t v) {
    const std::int64_t d = 2 * (v & (side - 1)) + 1 - side;
    return static_cast<std::uint64_t>(d * d);
  };
  return square(cell.x) + square(cell.y) + square(cell.z);
}

void sort_by_row(std::span<CopcPoint> points) {
  std::sort(points.begin(), points.end(), [](const CopcPoint& a, const CopcPoint& b) { return a.row < b.row; });
}

// Moves the points that the node keeps to the end and the others, still sorted, to the front. Returns the number of the
// others.
std::size_t keep_one_per_cell(std::span<CopcPoint> points, int level) {
  const int bits = std::max(0, kMortonBits - level - kCopcGridBits);
  std::vector<CopcPoint> kept;
  std::size_t others = 0;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const std::uint64_t cell = points[begin].code >> 3 * bits;
    std::size_t best = begin;
    std::uint64_t least = UINT64_MAX;
    for (end = begin; end < points.size() && points[end].code >> 3 * bits == cell; ++end) {
      const std::uint64_t off = off_centre(points[end].code, bits);
      if (off < least) best = end;
      least = std::min(least, off);
    }
    kept.push_back(points[best]);
    for (std::size_t i = begin; i < end; ++i)
      if (i != best) points[others++] = points[i];
  }
  sort_by_row(kept);
  std::copy(kept.begin(), kept.end(), points.begin() + static_cast<std::ptrdiff_t>(others));
  return others;
}

// Appends a node for each octant that has points. The octants are children of one node of `level` - 1.
void add_children(std::span<const CopcPoint> all, CopcNode range, std::vector<CopcNode>& nodes) {
  const int shift = shift_of(range.level);
  while (range.first < range.end) {
    const std::uint64_t code = all[range.first].code >> shift;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto after = std::partition_point(begin, all.begin() + static_cast<std::ptrdiff_t>(range.end),
                                            [&](const CopcPoint& p) { return p.code >> shift == code; });
    const std::uint64_t end = range.first + static_cast<std::uint64_t>(after - begin);
    nodes.push_back({range.level, morton_cell(code), range.first, end});
    range.first = end;
  }
}

}  // namespace

std::vector<CopcNode> build_copc_octree(std::vector<CopcPoint>& points) {
  std::sort(points.begin(), points.end(),
            [](const CopcPoint& a, const CopcPoint& b) { return a.code != b.code ? a.code < b.code : a.row < b.row; });
  std::vector<CopcNode> nodes{{0, {}, 0, points.size()}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const CopcNode node = nodes[i];
    const auto mine = std::span(points).subspan(node.first, node.end - node.first);
    if (mine.size() <= kCopcLeaf || node.level == kMortonBits) {
      sort_by_row(mine);
      continue;
    }
    nodes[i].first = node.first + keep_one_per_cell(mine, node.level);
    add_children(points, {node.level + 1, {}, node.first, nodes[i].first}, nodes);
  }
  return nodes;
}

}  // namespace ilot
