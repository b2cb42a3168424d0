// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/survey/point_summary.h"

#include <algorithm>

#include "engine/store/sorted_run.h"

namespace ilot {
namespace {

Index3 corner_of(CoarseCell cell, int bits) {
  return {cell.x << bits, cell.y << bits, cell.z << bits};
}

// Adds points of one cell and one chunk. A sum is looked up again only where the next point has another class or lies
// in another square.
class CellTally {
 public:
  CellTally(PointSums& sums, InputChunk chunk) : sums_(sums) {
    chunk_ = &sums_.chunks.try_emplace(chunk, IndexBox::none()).first->second;
  }
  CellTally(const CellTally&) = delete;
  CellTally& operator=(const CellTally&) = delete;
  ~CellTally() { end_square(); }

  void add(const LatticePoint& p) {
    ++sums_.points;
    chunk_->add(p.at);
    if (of_class_ == nullptr || p.classification != class_) of_class_ = &sums_.classes[class_ = p.classification];
    ++*of_class_;
    const int bits = sums_.map.bits();
    if (in_square_ > 0 && square_ != PlanSquare{p.at.y >> bits, p.at.x >> bits}) end_square();
    if (in_square_ == 0) square_ = {p.at.y >> sums_.map.bits(), p.at.x >> sums_.map.bits()};
    ++in_square_;
  }

 private:
  void end_square() {
    if (in_square_ > 0) sums_.map.add(square_, in_square_);
    in_square_ = 0;
  }

  PointSums& sums_;
  IndexBox* chunk_;
  std::uint8_t class_ = 0;
  std::uint64_t* of_class_ = nullptr;
  PlanSquare square_;
  std::uint64_t in_square_ = 0;
};

}  // namespace

void PointSums::add(const PointSums& other) {
  points += other.points;
  for (const auto& [code, count] : other.classes) classes[code] += count;
  map.add(other.map);
  for (const auto& [chunk, where] : other.chunks)
    chunks.try_emplace(chunk, IndexBox::none()).first->second.add_box(where);
}

IndexBox PointSums::box() const {
  IndexBox all = IndexBox::none();
  for (const auto& [chunk, where] : chunks) all.add_box(where);
  return all;
}

PointSummary::PointSummary(double step_metres)
    : cell_bits_(coarse_bits(step_metres)),
      square_bits_(std::min(square_bits(step_metres), cell_bits_)),
      cells_(cell_bits_),
      settled_(square_bits_) {}

// A cell of many places stays one whatever is added, and so does the larger cell that contains it.
bool PointSummary::is_many(CoarseCell cell) const {
  const int by = cells_.bits() - cell_bits_;
  const auto found = cells_.cells().find({cell.x >> by, cell.y >> by, cell.z >> by});
  return found != cells_.cells().end() && found->second.many;
}

PointSums& PointSummary::apart_at(CoarseCell cell) {
  const auto [at, is_new] = apart_.try_emplace(cell, square_bits_);
  if (is_new) {
    tiles_apart_.insert(key_of(corner_of(cell, cell_bits_)).tile);
    refuse_many_tiles(tiles_apart_.size());
  }
  return at->second;
}

void PointSummary::add(std::span<const LatticePoint> points, std::uint32_t input, const ChunkBoxes& chunks) {
  for (std::size_t i = 0; i < points.size();) {
    const std::size_t chunk = chunks.chunk_of(points[i].row);
    const CoarseCell cell = coarse_cell(points[i].at, cell_bits_);
    CellTally tally(is_many(cell) ? settled_ : apart_at(cell), {input, chunk});
    Tile tile = key_of(points[i].at).tile;
    tiles_.insert(tile);
    for (; i < points.size() && points[i].row < chunks.rows[chunk + 1] && coarse_cell(points[i].at, cell_bits_) == cell;
         ++i) {
      tally.add(points[i]);
      cells_.add(points[i].at);
      if (const Tile next = key_of(points[i].at).tile; next != tile) tiles_.insert(tile = next);
    }
  }
}

void PointSummary::add(const PointSummary& part) {
  cells_.merge(part.cells_);
  settled_.add(part.settled_);
  tiles_.insert(part.tiles_.begin(), part.tiles_.end());
  for (const auto& [cell, sums] : part.apart_) apart_at(cell).add(sums);
  settle();
}

void PointSummary::settle() {
  std::erase_if(apart_, [&](const auto& entry) {
    const bool many = is_many(entry.first);
    if (many) settled_.add(entry.second);
    return many;
  });
  tiles_apart_.clear();
  for (const auto& [cell, sums] : apart_) tiles_apart_.insert(key_of(corner_of(cell, cell_bits_)).tile);
}

std::pair<PointSums, std::uint64_t> PointSummary::without(const Strays& strays) && {
  std::pair<PointSums, std::uint64_t> all{std::move(settled_), 0};
  for (const auto& [cell, sums] : apart_) {
    if (strays.contains(corner_of(cell, cell_bits_)))
      all.second += sums.points;
    else
      all.first.add(sums);
  }
  return all;
}

}  // namespace ilot
