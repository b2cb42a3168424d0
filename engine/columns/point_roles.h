// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// What a class code means for buildings.
enum class PointRole : std::uint8_t {
  unclassified,  // never classified: may be anything
  building,
  ground,
  other,  // classified as something else
};

// The roles by class code. Codes 0 (never classified), 1 (unclassified) and 12 (overlap in old formats) may be
// anything.
std::array<PointRole, 256> point_roles(std::span<const int> building, std::span<const int> ground);

// The number of points of each role (PointRole) in the store.
using RoleCounts = std::array<std::uint64_t, 4>;

// Writes the column "role" (PointRole) of every block from its "class".
RoleCounts write_roles(const Store& store, const std::array<PointRole, 256>& roles, const PassContext& context);

// Sums the counts of blocks.
RoleCounts sum_of(std::span<const RoleCounts> counts);

inline std::uint64_t count_of(const RoleCounts& counts, PointRole role) {
  return counts[static_cast<std::size_t>(role)];
}

}  // namespace ilot
