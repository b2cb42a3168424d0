// SPDX-License-Identifier: Apache-2.0
// Counts the storeys of a building by the openings in its facades.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/model/facade_opening.h"
#include "engine/products/roofs/sites/outline_map.h"
#include "engine/products/roofs/solids/building_attributes.h"

namespace ilot {

// The openings of all facades of a run, found by place.
class StoreyCounter {
 public:
  StoreyCounter(std::span<const FacadeOpening> openings, double metres_per_unit);

  // Returns the number of storeys that show openings; nothing where no opening is in a wall of the outline. An opening
  // is in a wall when it lies within 1 m of an edge of the outline that faces the same way within 10 degrees: a roof
  // reaches so far over its walls. The openings whose middles are most within one metre of height are a storey, and
  // take those less than 2 m from their own middle with them: fanlights, stairs and cellar windows are no storeys. Then
  // the others follow likewise.
  // O(openings near the outline x its edges).
  std::optional<std::int64_t> storeys(const PlacedOutline& outline) const;

  // Adds the attribute `storeys` to those of the building with this outline, where storeys are seen.
  void add_to(BuildingAttributes& attributes, const PlacedOutline& outline) const;

 private:
  struct Opening {
    double x, y, z, out_x, out_y;  // metres
  };
  std::vector<Opening> openings_;  // by x, then by all else
};

}  // namespace ilot
