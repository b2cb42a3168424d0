// SPDX-License-Identifier: Apache-2.0
// A table of shapes in space with named values, independent of their meaning.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "kernels/core/types.h"

namespace ilot {

// A count as a value of a field.
inline std::int64_t whole(std::uint64_t n) {
  return static_cast<std::int64_t>(n);
}

enum class LayerShape { point, line, polygon };

// The first feature's value determines the kind of a column.
struct LayerFeature {
  std::vector<std::vector<Vec3>> rings;  // CRS; a point and a line have one ring; the first ring of a polygon is the
                                         // outer one, and an edge leads from the last corner of a ring to the first
  std::vector<AttributeValue> values;    // one for each field of the layer
};

struct Layer {
  std::string name;
  LayerShape shape = LayerShape::point;
  bool flat = false;  // heights are not written
  std::vector<std::string> fields;
  std::vector<LayerFeature> features;
};

}  // namespace ilot
