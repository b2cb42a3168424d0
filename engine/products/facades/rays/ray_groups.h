// SPDX-License-Identifier: Apache-2.0
// Brings the rays of each group together, whatever their number.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "engine/products/facades/rays/rays.h"

namespace ilot {

constexpr std::size_t kNoGroup = SIZE_MAX;

// Gives the rays of group 0, then those of group 1 and so on. Within a group the order stays. `counts` has the number
// of rays of each group. group_of gives the group of a ray, or kNoGroup for a ray that is left out. `grouped` is empty
// and is returned. Needs 1 MB, and 20 bytes per group beyond 32,768 groups.
RayColumn grouped_rays(const RayColumn& rays, std::span<const std::uint64_t> counts,
                       const std::function<std::size_t(const Ray&)>& group_of, RayColumn grouped);

}  // namespace ilot
