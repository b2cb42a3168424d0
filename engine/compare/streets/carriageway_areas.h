// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "engine/compare/streets/kerb_errors.h"
#include "engine/compare/truth.h"
#include "ilot/streets.h"

namespace ilot {

struct CarriagewayResult {
  std::uint64_t found = 0;  // polygons
  double found_m2 = 0;
  double correct = 0;   // share of found_m2 that is a true carriageway
  double true_m = 0;    // metres of true kerb that was seen
  double complete = 0;  // share of true_m at which a carriageway begins
};

// Compares the areas in plan. A carriageway begins at a place of a kerb where it has the point half a metre before the
// kerb, on either side. O(corners log corners + places corners).
CarriagewayResult evaluate_carriageways(const KerbSight& sight, std::span<const TrueCarriageway> truth,
                                        std::span<const Carriageway> found, double metres_per_unit);

}  // namespace ilot
