// SPDX-License-Identifier: Apache-2.0
// A building's points out of the store, wherever they lie.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/roofs/misalignment.h"
#include "engine/roofs/outline_map.h"
#include "engine/roofs/site_plan.h"
#include "engine/roofs/site_points.h"
#include "engine/store/store.h"

namespace ilot {

// What all sites of a run share. The store has the column "role" (PointRole).
struct SiteWork {
  const Store& store;
  std::span<const PlannedSite> sites;
  const OutlineMap& map;  // of their outlines
  SitePointsParams params;
  double metres_per_unit = 1;
};

// Where a point stands in the store.
struct StorePlace {
  std::uint32_t block = 0, point = 0;
};

struct GatheredSite {
  RoofSite site;
  std::vector<StorePlace> places;   // per point of the site
  bool by_class = true;             // see SitePoints
  std::uint64_t points_around = 0;  // of any class, over the outline and within reach of it
};

// Points that gathering the site will read: what its memory goes by. 0 without an outline.
std::uint64_t points_to_read(const SiteWork& work, std::size_t site);

// Reads whole columns over the outline, exactly: nothing depends on blocks. The site must have an outline.
GatheredSite gather_site(const SiteWork& work, std::size_t site);

// Counts the points of buildings around the site for a raster of shifts of the outlines.
ShiftCounts shifts_around(const SiteWork& work, std::size_t site);

}  // namespace ilot
