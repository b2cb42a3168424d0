// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/store/stretches.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// The place of a point in the store. Places ascend in global order.
struct StorePlace {
  std::uint32_t block = 0, point = 0;
  friend auto operator<=>(const StorePlace&, const StorePlace&) = default;
};

// A point of a stretch: its index in the stretch and its place on the lattice.
struct StretchPoint {
  std::uint32_t number = 0;
  Index3 position;
};

inline StorePlace place_of(const Stretch& s, const StretchPoint& p) {
  return {s.block, s.first + p.number};
}

// Calls visit(stretch, points) for the points of the store in the (closed) box in global order, some thousands at a
// time. `points` are the points of the stretch in the box; there is at least one. Less than 1 MiB of memory.
template <class Visit>
void for_each_stretch_in(const Store& store, const IndexBox& box, const Visit& visit) {
  std::vector<StretchPoint> inside;
  for_each_stretch(store, plan_view(store, box, {}).slices, [&](const Stretch& s) {
    inside.clear();
    for (std::uint32_t i = 0; i < s.codes.size(); ++i)
      if (const Index3 p = s.position(i); box.contains(p)) inside.push_back({i, p});
    if (!inside.empty()) visit(s, std::span<const StretchPoint>(inside));
  });
}

}  // namespace ilot
