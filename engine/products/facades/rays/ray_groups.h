// SPDX-License-Identifier: Apache-2.0
// Brings the rays of each group together, however many they are.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "engine/products/facades/rays/rays.h"

namespace ilot {

constexpr std::size_t kNoGroup = SIZE_MAX;

// The rays of group 0, then those of group 1 and so on, each in the order that they had. counts: of each group.
// group_of gives the group of a ray, kNoGroup for those that are left out. 1 MB, and 20 bytes a group beyond 32,768 of
// them.
RayColumn grouped_rays(const RayColumn& rays, std::span<const std::uint64_t> counts,
                       const std::function<std::size_t(const Ray&)>& group_of, const std::filesystem::path& folder);

}  // namespace ilot
