// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/cells.h"

#include <algorithm>
#include <cmath>

#include "engine/store/stretches.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr int kMarginShift = 4;  // margin = edge / 16

void reserve(CellPoints& cp, std::size_t points) {
  cp.reserve(points);
  cp.normals.reserve(points);
  cp.core.reserve(points);
}

// The number of points of the view that are in the box around a cell but not in the cell.
std::uint64_t count_margin(const Store& store, const View& plan, const IndexBox& around, const IndexBox& own) {
  std::uint64_t count = 0;
  for_each_stretch(store, plan.slices, [&](const Stretch& s) {
    for (std::size_t i = 0; i < s.codes.size(); ++i) {
      const Index3 p = s.position(i);
      count += around.contains(p) && !own.contains(p);
    }
  });
  return count;
}

int cell_level(double unit_metres) {
  int bits = 0;
  while (bits < kTileBits && std::ldexp(unit_metres, bits + 1) <= kCellMetres) ++bits;
  return kTileBits - bits;
}

// The first point of the slice whose code is at least `code`.
std::uint32_t lower_bound(const ColumnReader<std::uint64_t>& codes, const CellSlice& s, std::uint64_t code) {
  std::uint32_t lo = s.first, hi = s.first + s.count;
  while (lo < hi) {
    const std::uint32_t middle = lo + (hi - lo) / 2;
    if (codes.at(middle) < code) {
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
    for (int octant = 0; octant < 8; ++octant)
      children[static_cast<std::size_t>(octant)].node = cell.node.child(octant);
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
    const auto codes = store_.open(s.block, columns::kCodes);
    CellSlice rest = s;
    for (std::size_t octant = 0; octant < 8 && rest.count > 0; ++octant) {
      const std::uint32_t end = rest.first + rest.count;
      const std::uint32_t cut_at = octant == 7 ? end : lower_bound(codes, rest, children[octant + 1].node.first_code);
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

// Groups of blocks that belong to one largest cell; or one block that contains several such cells.
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

std::int64_t largest_cell(double unit_metres) {
  return std::int64_t{1} << (kTileBits - cell_level(unit_metres));
}

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

std::vector<std::vector<CellPiece>> pieces_of_blocks(const Store& store, const std::vector<Cell>& cells) {
  std::vector<std::vector<CellPiece>> pieces(store.blocks().size());
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    std::uint32_t offset = 0;
    for (const CellSlice& s : cells[c].slices) {
      pieces[s.block].push_back({c, offset, s});
      offset += s.count;
    }
  }
  return pieces;
}

std::int64_t margin_of(const Cell& cell) {
  return std::max<std::int64_t>(1, cell.node.edge() >> kMarginShift);
}

std::uint64_t points_to_load(const Store& store, const Cell& cell) {
  const View plan = plan_view(store, cell.node.box().grown(margin_of(cell)), cell.node.min_corner());
  return cell.points + std::min<std::uint64_t>(plan.size - cell.points, kCellPoints + kCellPoints / 64);  // by a hash
}

CellPoints load_cell(const Store& store, const Cell& cell, const ColourPalette& palette) {
  const IndexBox own = cell.node.box(), around = own.grown(margin_of(cell));
  const View plan = plan_view(store, around, cell.node.min_corner());
  std::uint64_t in_margin = plan.size - cell.points;  // upper bound
  if (in_margin > kCellPoints) in_margin = count_margin(store, plan, around, own);
  const bool thin = in_margin > kCellPoints;
  const std::uint64_t keep_below = thin ? UINT64_MAX / in_margin * kCellPoints : UINT64_MAX;
  CellPoints cp;
  reserve(cp, points_to_load(store, cell));
  for_each_stretch(store, plan.slices, [&](const Stretch& s) {
    const auto normals = s.read(store, columns::kNormals);
    std::vector<StoredColour> colours;
    if (!palette.centre.empty()) colours = s.read(store, columns::kColour);
    for (std::size_t i = 0; i < s.codes.size(); ++i) {
      const Index3 p = s.position(i);
      if (!around.contains(p)) continue;
      const bool core = own.contains(p);
      if (!core && thin && mix64(s.codes[i]) > keep_below) continue;
      cp.add(static_cast<float>(p.x - plan.anchor.x), static_cast<float>(p.y - plan.anchor.y),
             static_cast<float>(p.z - plan.anchor.z));
      cp.normals.push_back(normals[i]);
      cp.core.push_back(core);
      if (!colours.empty()) cp.colour_class.push_back(palette.class_of(colours[i]));
    }
  });
  cp.pad();
  return cp;
}

}  // namespace ilot
