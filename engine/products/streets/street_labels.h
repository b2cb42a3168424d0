// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/model/point_label.h"
#include "engine/products/product_labels.h"
#include "engine/products/streets/street_tiles.h"

namespace ilot {

// The street label of a point: an entry of the column "street".
struct StreetLabel {
  std::uint32_t object = 0;  // 0 = none
  PointLabel label = PointLabel::none;
  std::uint8_t unused[3] = {};  // padding that is written to disk
};

// Per candidate number, [0] unused: its object (0: none), its label, and its top.
struct ObjectLabels {
  std::vector<std::uint32_t> object;
  std::vector<PointLabel> label;
  std::vector<double> top;  // metres above the ground; what is higher in its pixels is vegetation
};

// Writes the column "street" of every block from the layers "level", "mask" and "candidates". Points lower than
// least_height above the ground are ground. A higher point belongs to the candidate of its pixel. Outside of the mask,
// near the ground, higher points are facade. Points outside of the wanted area stay without a label.
void write_street_labels(const Store& store, const StreetTiles& tiles, const ObjectLabels& candidates,
                         double least_height, const PassContext& context);

// Labels from the column "street".
ProductLabels street_labels();

}  // namespace ilot
