// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

#include "engine/pass/context.h"
#include "engine/roofs/site_points.h"
#include "engine/store/store.h"

namespace ilot {

// Points of each role (PointRole) in the store.
using RoleCounts = std::array<std::uint64_t, 4>;

// Writes the column "role" (PointRole) of every block from its "class".
RoleCounts write_roles(const Store& store, const std::array<PointRole, 256>& roles, const PassContext& context);

inline std::uint64_t count_of(const RoleCounts& counts, PointRole role) {
  return counts[static_cast<std::size_t>(role)];
}

}  // namespace ilot
