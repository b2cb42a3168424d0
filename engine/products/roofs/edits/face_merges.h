// SPDX-License-Identifier: Apache-2.0
// Faces of roofs that a person says are one, by building.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/model/edit.h"
#include "engine/products/roofs/sites/outline_map.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/sites/site_plan.h"

namespace ilot {

struct PlannedMerge {
  const Edit* edit = nullptr;
  std::optional<std::size_t> site;  // whose outline has both places; none: see `reason`
  std::string reason;
  FaceMerge places;
};

// The edits of roofs that merge faces, in their order. The first site whose outline contains both places has the edit.
// O(edits, and corners of the outlines around their places). The edits must outlive the result.
std::vector<PlannedMerge> plan_merges(std::span<const Edit> edits, std::span<const PlannedSite> sites,
                                      const OutlineMap& map, double metres_per_unit);

// The merges of one site, in their order.
std::vector<FaceMerge> merges_of(std::span<const PlannedMerge> merges, std::size_t site);

}  // namespace ilot
