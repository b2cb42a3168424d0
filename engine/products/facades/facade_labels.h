// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "engine/model/point_label.h"
#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_gathering.h"
#include "engine/products/product_labels.h"

namespace ilot {

// The label of a point in the column "facade".
struct FacadeLabel {
  std::uint32_t element = 0;  // its id within the facade; 0 = none
  std::uint16_t facade = 0;   // 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused = 0;  // padding that is written to disk
};

// Writes the column "facade" of every block. A point gets the label of the first facade (the largest) to which it
// belongs. It belongs to an element before the wall if it is within epsilon of it; of several, to the smallest. It
// belongs to an opening if it is seen through the wall inside of that opening. If it is on the wall, it belongs to the
// stone that contains it, otherwise to the outline, as the points in joints do. The ray of a point comes from its own
// station where that is recorded, or from the only station; otherwise it is perpendicular to the wall. `walls` and
// `found` are parallel lists. Facades beyond number 65,535 label nothing. Points that are not wanted get no label.
// O(points).
void write_facade_labels(const FacadeWork& work, std::span<const WallGroup> walls, std::span<const FoundFacade> found,
                         const PassContext& context);

// Labels from the column "facade".
ProductLabels facade_labels();

}  // namespace ilot
