// SPDX-License-Identifier: Apache-2.0
// Finds which facades stand side by side along a street, or before and behind each other.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "engine/model/facade.h"

namespace ilot {

struct RowParams {
  double gap = 3;           // metres between two neighbours
  double step = 1.5;        // metres by which one stands before or behind the other
  double turn_deg = 10;     // angle between them
  double least_height = 2;  // metres of their height that they have in common
  double metres_per_unit = 1;
};

// The rows of two facades and more: indices of their facades from left to right. The row with the smallest index comes
// first. A later facade of which most stands before or behind an earlier one is in its row and comes after it. Facades
// above each other are no neighbours. O(facades^2).
std::vector<std::vector<std::size_t>> facade_rows(std::span<const Facade> facades, const RowParams& params);

}  // namespace ilot
