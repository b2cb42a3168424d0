// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "engine/model/point_label.h"
#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_gathering.h"

namespace ilot {

// What a facade says of a point: the column "facade".
struct FacadeLabel {
  std::uint32_t element = 0;  // its id within the facade; 0 = none
  std::uint16_t facade = 0;   // 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused = 0;  // written to disk
};

// Writes the column "facade" of every block. A point is of the first facade (the largest) that says something of it:
// within epsilon of a thing that stands before the wall, of the smallest of those; seen through the wall inside of an
// opening, of that; on the wall of a stone that holds it, else of the outline, as what lies in its joints. Rays come
// from a point's own station where it is told or the only one, else straight at the wall. walls and found belong
// together; facades beyond 65,535 label nothing. Points that are not wanted stay without a label. O(points).
void write_facade_labels(const FacadeWork& work, std::span<const WallGroup> walls, std::span<const FoundFacade> found,
                         const PassContext& context);

}  // namespace ilot
