// SPDX-License-Identifier: Apache-2.0
#include "engine/store/coarse_cells.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ilot {
namespace {

bool comes_before(Index3 a, Index3 b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

void add_place(CellContent& content, Index3 p) {
  if (content.many) return;
  const auto at = std::lower_bound(content.places.begin(), content.places.end(), p, comes_before);
  if (at != content.places.end() && *at == p) return;
  content.places.insert(at, p);
  if (content.places.size() < kFewPlaces) return;
  content.many = true;
  std::vector<Index3>().swap(content.places);
}

void add_content(CellContent& to, const CellContent& from) {
  to.points += from.points;
  if (from.many) {
    to.many = true;
    std::vector<Index3>().swap(to.places);
  }
  for (const Index3& p : from.places) add_place(to, p);
}

void add_points(CellContent& content, Tile tile, std::span<const KeyValue> points) {
  content.points += points.size();
  for (std::size_t i = 0; i < points.size() && !content.many; ++i)
    if (i == 0 || points[i].key != points[i - 1].key) add_place(content, index_of({tile, points[i].key}));
}

}  // namespace

CellContent& CoarseCells::at(CoarseCell cell) {
  if (last_ == nullptr || !(cell == last_cell_)) {
    last_ = &cells_[cell];
    last_cell_ = cell;
  }
  return *last_;
}

void CoarseCells::add(Index3 p) {
  CellContent& content = at(coarse_cell(p, bits_));
  ++content.points;
  add_place(content, p);
  shrink();
}

void CoarseCells::add(Tile tile, std::span<const KeyValue> points) {
  while (!points.empty()) {
    const int shift = 3 * std::min(bits_, kTileBits);  // the codes of one cell are consecutive
    const std::uint64_t cell = points.front().key >> shift;
    const auto end =
        std::partition_point(points.begin(), points.end(), [&](const KeyValue& p) { return p.key >> shift == cell; });
    const auto count = static_cast<std::size_t>(end - points.begin());
    add_points(at(coarse_cell(index_of({tile, points.front().key}), bits_)), tile, points.first(count));
    points = points.subspan(count);
    shrink();
  }
}

void CoarseCells::merge(CoarseCells other) {
  if (other.bits_ < bits_) other.coarsen_to(bits_);
  if (bits_ < other.bits_) coarsen_to(other.bits_);
  for (const auto& [cell, content] : other.cells_) {
    const int by = bits_ - other.bits_;  // greater than zero when there are too many cells
    add_content(at({cell.x >> by, cell.y >> by, cell.z >> by}), content);
    shrink();
  }
}

void CoarseCells::shrink() {
  while (cells_.size() > kMostCoarseCells) coarsen_to(bits_ + 1);
}

void CoarseCells::coarsen_to(int bits) {
  const int by = bits - bits_;
  std::map<CoarseCell, CellContent> coarse;
  for (const auto& [cell, content] : cells_) add_content(coarse[{cell.x >> by, cell.y >> by, cell.z >> by}], content);
  cells_ = std::move(coarse);
  bits_ = bits;
  last_ = nullptr;
}

std::vector<std::int64_t> CoarseCells::packed() const {
  std::vector<std::int64_t> out{bits_};
  for (const auto& [cell, content] : cells_) {
    out.insert(out.end(), {cell.x, cell.y, cell.z, static_cast<std::int64_t>(content.points), content.many,
                           static_cast<std::int64_t>(content.places.size())});
    for (const Index3& p : content.places) out.insert(out.end(), {p.x, p.y, p.z});
  }
  return out;
}

CoarseCells CoarseCells::unpacked(std::span<const std::int64_t> packed) {
  constexpr std::size_t kHead = 6;
  CoarseCells result(static_cast<int>(packed[0]));
  for (std::size_t i = 1; i < packed.size();) {
    CellContent& content = result.cells_[{packed[i], packed[i + 1], packed[i + 2]}];
    content.points = static_cast<std::uint64_t>(packed[i + 3]);
    content.many = packed[i + 4] != 0;
    const auto places = static_cast<std::size_t>(packed[i + 5]);
    i += kHead;
    for (std::size_t p = 0; p < places; ++p, i += 3)
      content.places.push_back({packed[i], packed[i + 1], packed[i + 2]});
  }
  return result;
}

int coarse_bits(double unit_metres) {
  constexpr int kMost = 40;  // of the 52 of a lattice coordinate
  int bits = 0;
  while (bits < kMost && std::ldexp(unit_metres, bits + 1) <= kCoarseMetres) ++bits;
  return bits;
}

}  // namespace ilot
