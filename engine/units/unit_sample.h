// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "engine/units/thinning.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// Points that a method can have in memory at once: all points of a unit, or those that Thinning keeps.
struct UnitSample {
  std::vector<KeptPoint> points;  // by place
  std::uint64_t total = 0;        // points of the unit
  Index3 corner;  // smallest coordinates of all of them; for a unit without points, far beyond all places
  bool thinned() const { return points.size() < total; }
};

// Collects the points of a unit while they are no more than `most`, counts them and finds their lowest corner.
class UnitCollector {
 public:
  explicit UnitCollector(std::size_t most) : most_(most) {}

  void add(const KeptPoint& p) {
    corner_ = {std::min(corner_.x, p.position.x), std::min(corner_.y, p.position.y), std::min(corner_.z, p.position.z)};
    if (++total_ <= most_) return points_.push_back(p);
    points_ = {};
  }
  bool has_all() const { return total_ <= most_; }
  std::uint64_t total() const { return total_; }
  Index3 corner() const { return corner_; }
  std::vector<KeptPoint> take() { return std::move(points_); }

 private:
  static constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  std::size_t most_;
  std::vector<KeptPoint> points_;
  std::uint64_t total_ = 0;
  Index3 corner_{kFar, kFar, kFar};
};

// Reads the points of the box that belong to the unit. takes(stretch) gives a function that decides this for a
// StretchPoint of that stretch. One reading, two when the unit has more than `most` points.
template <class Takes>
UnitSample sample_unit(const Store& store, const IndexBox& box, std::size_t most, const Takes& takes) {
  const auto for_each = [&](const auto& visit) {
    for_each_stretch_in(store, box, [&](const Stretch& s, std::span<const StretchPoint> inside) {
      const auto taken = takes(s);
      for (const StretchPoint& p : inside)
        if (taken(p)) visit(KeptPoint{place_of(s, p), p.position});
    });
  };
  UnitCollector all(most);
  for_each([&](const KeptPoint& p) { all.add(p); });
  if (all.has_all()) return {all.take(), all.total(), all.corner()};
  Thinning thinning(all.corner(), most);
  for_each([&](const KeptPoint& p) { thinning.add(p.position, p.place); });
  return {thinning.take(), all.total(), all.corner()};
}

}  // namespace ilot
