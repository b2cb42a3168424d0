// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/cells.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr int kMarginShift = 4;  // margin = edge / 16

IndexBox with_margin(const Node& node) { return node.box().grown(std::max<std::int64_t>(1, node.edge() >> kMarginShift)); }

int cell_level(double unit_metres) {
  int bits = 0;
  while (bits < kTileBits && std::ldexp(unit_metres, bits + 1) <= kCellMetres) ++bits;
  return kTileBits - bits;
}

// First point of the slice whose code is not below `code`.
std::uint32_t lower_bound(const ColumnReader& codes, const CellSlice& s, std::uint64_t code) {
  std::uint32_t lo = s.first, hi = s.first + s.count;
  while (lo < hi) {
    const std::uint32_t middle = lo + (hi - lo) / 2;
    std::uint64_t value = 0;
    codes.read<std::uint64_t>(middle, std::span(&value, 1));
    if (value < code) {
      lo = middle + 1;
    } else {
      hi = middle;
    }
  }
  return lo;
}

class Cutter {
 public:
  Cutter(const Store& store, int level) : store_(store), level_(level) {}

  void cut(Cell cell, std::vector<Cell>& cells) const {
    if (cell.points == 0) return;
    const bool small_enough = cell.node.level >= level_ && cell.points <= kCellPoints;
    if (small_enough || cell.node.level == kTileBits) {
      cells.push_back(std::move(cell));
      return;
    }
    std::vector<Cell> children(8);
    for (int octant = 0; octant < 8; ++octant) children[static_cast<std::size_t>(octant)].node = cell.node.child(octant);
    for (const CellSlice& s : cell.slices) deal(s, children);
    for (Cell& child : children) cut(std::move(child), cells);
  }

 private:
  void deal(const CellSlice& s, std::vector<Cell>& children) const {
    const Node& block = store_.blocks()[s.block].node;
    for (Cell& child : children) {
      if (!child.node.contains(block)) continue;
      return give(child, s);
    }
    const ColumnReader codes(store_.path(s.block, "codes"));
    CellSlice rest = s;
    for (std::size_t octant = 0; octant < 8 && rest.count > 0; ++octant) {
      const std::uint32_t end = rest.first + rest.count;
      const std::uint32_t cut_at =
          octant == 7 ? end : lower_bound(codes, rest, children[octant + 1].node.first_code);
      if (cut_at > rest.first) give(children[octant], {s.block, rest.first, cut_at - rest.first});
      rest = {s.block, cut_at, end - cut_at};
    }
  }

  static void give(Cell& cell, const CellSlice& s) {
    cell.slices.push_back(s);
    cell.points += s.count;
  }

  const Store& store_;
  int level_;
};

// Blocks of one largest cell, or the one block that holds several of them.
std::vector<Cell> roots(const Store& store, int level) {
  std::vector<Cell> found;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    const Block& block = store.blocks()[b];
    const Node node = block.node.level <= level ? block.node : block.node.ancestor(level);
    if (found.empty() || !(found.back().node == node)) found.push_back({node, 0, {}});
    found.back().slices.push_back({b, 0, block.points});
    found.back().points += block.points;
  }
  return found;
}

}  // namespace

std::vector<Cell> canonical_cells(const Store& store, double metres_per_unit) {
  const int level = cell_level(store.unit() * metres_per_unit);
  const std::vector<Cell> from = roots(store, level);
  std::vector<std::vector<Cell>> parts(from.size());
  const Cutter cutter(store, level);
  parallel_for(from.size(), [&](std::size_t i) { cutter.cut(from[i], parts[i]); });
  std::vector<Cell> cells;
  for (auto& part : parts)
    for (Cell& cell : part) cells.push_back(std::move(cell));
  return cells;
}

View cell_view(const Store& store, const Cell& cell) {
  return load_view(store, with_margin(cell.node), cell.node.min_corner());
}

CellPoints cell_points(const View& view, const Cell& cell) {
  const auto margin = static_cast<float>(std::max<std::int64_t>(1, cell.node.edge() >> kMarginShift));
  const auto edge = static_cast<float>(cell.node.edge());
  const auto inside = [&](float v, float grown) { return v >= -grown && v <= edge - 1 + grown; };
  CellPoints cp;
  for (std::uint32_t i = 0; i < view.size; ++i) {
    const float x = view.x[i], y = view.y[i], z = view.z[i];
    if (!inside(x, margin) || !inside(y, margin) || !inside(z, margin)) continue;
    cp.x.push_back(x);
    cp.y.push_back(y);
    cp.z.push_back(z);
    cp.view_index.push_back(i);
    cp.core.push_back(inside(x, 0) && inside(y, 0) && inside(z, 0));
  }
  cp.size = cp.view_index.size();
  constexpr std::size_t kPadding = 16;
  for (auto* v : {&cp.x, &cp.y, &cp.z}) v->resize(cp.size + kPadding, 0.0f);
  return cp;
}

}  // namespace ilot
