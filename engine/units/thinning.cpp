// SPDX-License-Identifier: Apache-2.0
#include "engine/units/thinning.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <tuple>
#include <utility>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

std::uint64_t hash_of(Index3 p) {
  const auto mixed = [](std::uint64_t seed, std::int64_t v) { return mix64(seed ^ static_cast<std::uint64_t>(v)); };
  return mixed(mixed(mixed(0, p.x), p.y), p.z);
}

}  // namespace

Thinning::Thinning(Index3 corner, std::size_t most)
    : corner_(corner), most_(most), slots_(std::bit_ceil(2 * std::max<std::size_t>(most, 1))) {}

void Thinning::add(Index3 position, StorePlace place) {
  const Index3 offset{position.x - corner_.x, position.y - corner_.y, position.z - corner_.z};
  assert(offset.x >= 0 && offset.y >= 0 && offset.z >= 0);
  put({offset, hash_of(offset), place});
  while (used_ > most_) coarsen();
}

std::vector<KeptPoint> Thinning::take() {
  std::vector<KeptPoint> kept;
  kept.reserve(used_);
  for (const Slot& s : slots_)
    if (s.place != kNowhere)
      kept.push_back({s.place, {corner_.x + s.offset.x, corner_.y + s.offset.y, corner_.z + s.offset.z}});
  slots_ = {};
  used_ = 0;
  std::sort(kept.begin(), kept.end(), [](const KeptPoint& a, const KeptPoint& b) { return a.place < b.place; });
  return kept;
}

bool Thinning::same_cube(Index3 a, Index3 b) const {
  return a.x >> level_ == b.x >> level_ && a.y >> level_ == b.y >> level_ && a.z >> level_ == b.z >> level_;
}

std::size_t Thinning::first_slot(Index3 offset) const {
  return hash_of({offset.x >> level_, offset.y >> level_, offset.z >> level_}) & (slots_.size() - 1);
}

void Thinning::put(const Slot& point) {
  const auto order = [](const Slot& s) { return std::tie(s.rank, s.offset.x, s.offset.y, s.offset.z, s.place); };
  for (std::size_t at = first_slot(point.offset);; at = (at + 1) & (slots_.size() - 1)) {
    Slot& slot = slots_[at];
    if (slot.place == kNowhere) {
      slot = point;
      ++used_;
      return;
    }
    if (!same_cube(slot.offset, point.offset)) continue;
    if (order(point) < order(slot)) slot = point;
    return;
  }
}

// Merges eight cubes into one.
void Thinning::coarsen() {
  std::vector<Slot> points;
  points.reserve(used_);
  for (Slot& s : slots_)
    if (s.place != kNowhere) points.push_back(std::exchange(s, Slot{}));
  used_ = 0;
  ++level_;
  for (const Slot& p : points) put(p);
}

}  // namespace ilot
