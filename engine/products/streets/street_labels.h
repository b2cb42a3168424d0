// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/model/point_label.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

// What a street says of a point: the column "street".
struct StreetLabel {
  std::uint32_t object = 0;  // 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused[3] = {};  // written to disk
};

// Of things by number, [0] unused: the object that a thing is (0: none), and its label.
struct ObjectLabels {
  std::vector<std::uint32_t> object;
  std::vector<PointLabel> label;
};

// Writes the column "street" of every block, from the layers "level", "mask" and "candidates": points lower than
// least_height above the ground are ground; higher ones belong to the thing of their pixel; where the mask ends and the
// ground is near they are facade. Points that are not wanted stay without a label.
void write_street_labels(const Store& store, const StreetTiles& tiles, const ObjectLabels& candidates,
                         double least_height, const PassContext& context);

}  // namespace ilot
