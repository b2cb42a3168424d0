// SPDX-License-Identifier: Apache-2.0
// A table of shapes in space with named values, whatever they stand for.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "kernels/core/types.h"

namespace ilot {

enum class LayerShape { point, line, polygon };

// A column takes its kind from the first feature's value.
struct LayerFeature {
  std::vector<std::vector<Vec3>> rings;  // CRS; a point and a line have one, a polygon's first one is the outer one and
                                         // from the last corner of a ring an edge leads to the first
  std::vector<AttributeValue> values;    // as many as the layer has fields
};

struct Layer {
  std::string name;
  LayerShape shape = LayerShape::point;
  bool flat = false;  // heights are not written
  std::vector<std::string> fields;
  std::vector<LayerFeature> features;
};

}  // namespace ilot
